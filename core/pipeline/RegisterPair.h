#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/pipeline/InitialPlacement.h"
#include "core/registration/RegistrationWatch.h"
#include "core/scene/Scene.h"

namespace vestige {

/// What a registration starts with, once unit and first pose are known.
struct PreparedRegistration {
    TriangleMesh
        target;  ///< metres, preprocessed; the part within reach of the scan where the first pose is given
    Similarity initial;             ///< its scale: metres per unit of the source
    std::optional<double> error_m;  ///< of the first pose, where picked pairs tell it
    /// Edge of the first NDT cell where the first pose needs no larger one, though its error is not known so
    /// well that a fit may be held against it.
    std::optional<double> voxelStart_m{};
    std::vector<std::string> notes;
    std::optional<FirstPose> found;  ///< by the search, where the layer's first pose is automatic
};

/// The preprocessed part of one loaded layer that another is registered to, from this first placement.
/// ErrorCode::untrustworthy when it puts the source where the target has no points.
Result<PreparedRegistration> preparePair(const SceneState& scene, const Layer& target, const Layer& source,
                                         const InitialPlacement& placement, const JobControl& control);

/// Registers the layer to what was prepared for it with the scene's parameters. A pose that cannot be relied
/// on is returned too, with its verdict, the reasons and what a search had found.
Result<RegistrationResult> attemptPair(const SceneState& scene, const Layer& source,
                                       const PreparedRegistration& prepared, const JobControl& control,
                                       const RegistrationWatch& watch = {});
/// The same, but such a pose is ErrorCode::untrustworthy.
Result<RegistrationResult> registerPair(const SceneState& scene, const Layer& source,
                                        const PreparedRegistration& prepared, const JobControl& control,
                                        const RegistrationWatch& watch = {});

/// That the layer's pose cannot be relied on, and why.
Error unreliable(const RegistrationResult& result, const std::string& layer);

}  // namespace vestige
