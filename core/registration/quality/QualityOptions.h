#pragma once

#include "core/base/ParameterSet.h"

namespace vestige {

/// The thresholds of a verdict; rows of registrationParameters().
struct QualityOptions {
    int restarts = 4;
    double leastOverlap = 0.1;            ///< below: failed
    double failedSupport = 0.03;          ///< below: failed
    double doubtfulSupport = 0.12;        ///< below: doubtful
    double freeSigma_m = 0.1;             ///< standard deviation of a direction that counts as free
    double doubtfulUncertainty_m = 0.08;  ///< longest half axis of the 95 % ellipsoid
};

QualityOptions qualityOptions(const ParameterSet& parameters);

}  // namespace vestige
