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
    double doubtfulSeenThrough = 0.04;    ///< share of surface that a scanner saw through; above: doubtful
    double failedSeenThrough = 0.1;       ///< above: failed
    double doubtfulUncertainty_m = 0.08;  ///< half axis of the 95 % ellipsoid of the source's middle
    double doubtfulTurn_deg = 0.8;        ///< and of the rotation
};

QualityOptions qualityOptions(const ParameterSet& parameters);

}  // namespace vestige
