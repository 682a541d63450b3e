#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry/Pose.h"
#include "core/geometry/PoseUncertainty.h"

namespace vestige {

/// One pair of layers that were registered to each other, and what became of it when all were adjusted.
struct AdjustedPair {
    std::string to;    ///< layer
    std::string from;  ///< layer; the pose maps its points into the frame of `to`
    bool used = false;
    std::string whyNot;               ///< for a pair that is not used, in plain words
    std::optional<Similarity> found;  ///< metres of `to` from the file unit of `from`; nothing when the
                                      ///< search for it failed
    double overlap = 0;
    double rmse_m = 0;
    PoseUncertainty uncertainty;  ///< a priori, frame of `to`
    double correction_m = 0;      ///< by which the adjustment moved the middle of the overlap
    double correction_rad = 0;
    bool controlled = false;  ///< other pairs say the same thing
    double chiSquare = 0;     ///< what the pair adds to the sum of squares; 6 degrees of freedom
};

/// A way through the pairs that ends where it began.
struct AdjustedLoop {
    std::vector<std::string> layers;  ///< in order; the last is tied to the first
    double translation_m = 0;         ///< by which it fails to close, before the adjustment
    double rotation_rad = 0;
    double chiSquare = 0;    ///< of 6 degrees of freedom
    double probability = 1;  ///< of failing by as much where the pairs' covariances are true
};

/// A layer's place before (through its surest chain of pairs) and after.
struct AdjustedLayer {
    std::string layer;
    double moved_m = 0;
    double moved_rad = 0;
    PoseUncertainty before;
    PoseUncertainty after;
};

/// All registrations of a case, adjusted together by least squares.
struct JointAdjustment {
    std::vector<AdjustedPair> pairs;
    std::vector<AdjustedLoop> loops;
    std::vector<AdjustedLayer> layers;
    double chiSquare = 0;
    int degreesOfFreedom = 0;
    double varianceFactor = 1;  ///< sum of squares by degrees of freedom
    bool consistent = true;     ///< false: the covariances were multiplied by the variance factor
};

}  // namespace vestige
