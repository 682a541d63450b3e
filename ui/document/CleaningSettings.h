#pragma once

#include "core/filters/CleaningParameters.h"

namespace vestige {

/// What the steps of cleaning are asked with next; the steps done say what they were asked with.
struct CleaningSettings {
    ParameterSet outline{outlineParameters()};
    ParameterSet outliers{outlierSearchParameters()};
    ParameterSet ground{groundSearchParameters()};
    ParameterSet objects{objectSearchParameters()};
};

}  // namespace vestige
