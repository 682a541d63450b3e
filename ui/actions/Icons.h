#pragma once

#include <QIcon>

class QPalette;

namespace vestige {

/// A line drawing of resources/icons by name, in the palette's colour for words on buttons; white where it is
/// switched on, for its button is filled then.
QIcon iconOn(const QPalette& palette, const QString& name);

}  // namespace vestige
