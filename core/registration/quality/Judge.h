#pragma once

#include <string>
#include <vector>

#include "core/registration/RegistrationResult.h"
#include "core/registration/quality/QualityOptions.h"
#include "core/registration/quality/SurfaceFit.h"

namespace vestige {

/// Another pose of the same pair, to hold against the found one.
struct Rival {
    double away_m = 0;      ///< of the source's surface from where the found pose puts it
    double score = 0;       ///< poseScore
    double through = 0;     ///< share of surface that a scanner saw through
    bool perturbed = true;  ///< a start near the result led here; else it was sought for its likeness
};

/// How far a pose may be off, 95 %, where it is held least.
struct Reach {
    double size = 0;    ///< metres, or radians
    std::string words;  ///< which way
};

/// What a verdict stands on, besides RegistrationResult and RegistrationQuality.
struct Evidence {
    SurfaceShares source;
    SurfaceShares target;
    double score = 0;    ///< poseScore
    double through = 0;  ///< the larger share of one cloud's surface that the other's scanner saw through
    bool freeSpaceKnown = false;  ///< of both scanners
    std::vector<Rival> rivals;
    double apart_m = 0;   ///< a rival that is nearer is the same place
    double radius_m = 1;  ///< of the source's surface
    Reach shift;          ///< of the middle of the source
    Reach turn;
};

struct Judgement {
    Verdict verdict = Verdict::accepted;
    std::vector<std::string> reasons;
};

/// Whether free space speaks for one of two poses: the other has several times its share of surface seen
/// through, and more than chance gives.
bool clearer(double through, double otherThrough);

/// Failed, doubtful or accepted, with a reason for every threshold that is crossed; an accepted one says what
/// speaks for it.
Judgement judge(const RegistrationResult& result, const RegistrationQuality& quality,
                const Evidence& evidence, const QualityOptions& options);

}  // namespace vestige
