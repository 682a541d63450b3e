#pragma once

#include <QColor>
#include <QString>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// A colour of the window by its name in the style sheet; invalid for an unknown name.
QColor styleColor(const QString& name, Theme theme);

/// The style sheet with "@name" replaced by that theme's colours; unknown names stay.
QString withColors(const QString& sheet, Theme theme);

}  // namespace vestige
