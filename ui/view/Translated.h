#pragma once

#include <QString>
#include <string_view>

#include "core/base/Translation.h"

namespace vestige {

/// A text that is painted into a picture, in the language of the process; what stands in it is given in
/// English.
inline QString translated(std::string_view english) {
    return QString::fromStdString(say(english));
}

}  // namespace vestige
