#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/registration/RegistrationResult.h"
#include "core/registration/quality/QualityOptions.h"
#include "core/registration/quality/SurfaceFit.h"

namespace vestige {

/// What a verdict stands on, besides RegistrationResult and RegistrationQuality.
struct Evidence {
    SurfaceShares source;
    SurfaceShares target;
    std::optional<double> betterElsewhere_m;  ///< how far away a restart found a pose that fits as well
    bool muchBetter = false;                  ///< and better than this one
    double longestHalfAxis_m = 0;             ///< of the 95 % ellipsoid
};

struct Judgement {
    Verdict verdict = Verdict::accepted;
    std::vector<std::string> reasons;
};

/// Failed, doubtful or accepted, with a reason for every threshold that is crossed; an accepted one says what
/// speaks for it.
Judgement judge(const RegistrationResult& result, const RegistrationQuality& quality,
                const Evidence& evidence, const QualityOptions& options);

}  // namespace vestige
