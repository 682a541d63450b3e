#pragma once

#include <QString>

#include "core/base/ParameterSpec.h"

namespace vestige {

/// What a parameter means, from where to where it goes, and what it is when nobody sets it, in the language
/// of the window: "Edge of the smallest cells. Range: 0.01 to 10 m; default: automatic."
QString parameterHelp(const ParameterSpec& spec);

}  // namespace vestige
