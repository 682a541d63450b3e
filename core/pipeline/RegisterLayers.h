#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/pipeline/RegisterPair.h"
#include "core/scene/Scene.h"

namespace vestige {

/// True for a layer that the pipeline registers: a handheld scan, any other layer that the case gives a first
/// pose for, and with the parameter "strips" every aerial layer besides the target. A photogrammetry cloud
/// without one is compared as it comes, in its own frame.
bool needsRegistration(const SceneState& scene, const Layer& layer);

/// Unit, first pose and the preprocessed target of one loaded layer. ErrorCode::input for an initial pose
/// that cannot be had (broken picks), ErrorCode::untrustworthy when the pose puts the scan away from the
/// target, the picks do not determine it or the search finds no place.
Result<PreparedRegistration> prepareRegistration(const SceneState& scene, const std::string& layer,
                                                 const JobControl& control);
Result<RegistrationResult> registerPrepared(const SceneState& scene, const std::string& layer,
                                            const PreparedRegistration& prepared, const JobControl& control,
                                            const RegistrationWatch& watch = {});

/// Registers one loaded layer of the scene to its target: unit, first pose, preprocessing of the target, NDT.
/// Reads the state only; any thread. Several layers that overlap each other: registerLayers().
Result<RegistrationResult> registerLayer(const SceneState& scene, const std::string& layer,
                                         const JobControl& control, const RegistrationWatch& watch = {});

}  // namespace vestige
