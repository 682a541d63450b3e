#pragma once

#include <functional>

#include "core/geometry/Pose.h"

namespace vestige {

/// One iteration of a registration, for those who watch it.
struct RegistrationStep {
    int level = 0;  ///< of the voxel schedule, from 0
    int levels = 0;
    int iteration = 0;  ///< of the level, from 0 (its start)
    double voxel_m = 0;
    double score = 0;
    double trustRadius_m = 0;
    double step_m = 0;            ///< length of the step that was tried; 0 at a level's start
    bool taken = true;            ///< a step that does not lower the score is not taken
    Similarity targetFromSource;  ///< the best pose so far
};

/// Called on the registration's thread after each iteration. Empty: nobody watches, and nothing is spent.
using RegistrationWatch = std::function<void(const RegistrationStep&)>;

}  // namespace vestige
