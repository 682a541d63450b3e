#pragma once

#include <string>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Registers one loaded layer of the scene to its target: unit, first pose, preprocessing of the target, NDT.
/// Reads the state only; any thread. The window and `reconstruct` call this one function.
Result<RegistrationResult> registerLayer(const SceneState& scene, const std::string& layer,
                                         const JobControl& control);

}  // namespace vestige
