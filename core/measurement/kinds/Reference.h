#pragma once

#include "core/base/ParameterSpec.h"

namespace vestige {

/// What the true value of a figure that is no length is known to be, and how well. 0: not known.
inline ParameterSpec referenceParameter(const char* key, const char* unit) {
    return {key,
            "",
            "Reference value",
            unit,
            ParameterType::real,
            0.0,
            0.0,
            1e9,
            {},
            "What another method says, to compare with; 0 where there is none."};
}

}  // namespace vestige
