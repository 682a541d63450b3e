#pragma once

#include <QByteArray>

namespace vestige {

/// The file with its random identifier (the /ID of the trailer) replaced by one made from its content, so
/// that equal content gives equal bytes. A file without /ID comes back as it is.
QByteArray withContentIdentity(QByteArray pdf);

}  // namespace vestige
