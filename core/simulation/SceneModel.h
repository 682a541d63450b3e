#pragma once

#include <map>
#include <string>

#include "core/base/Result.h"
#include "core/simulation/RayTracer.h"
#include "core/simulation/SceneSpec.h"
#include "core/simulation/SurfaceModel.h"

namespace vestige {

/// The scene as surfaces in the site frame, with the pose of every object. Parts and features are named
/// "OBJECT.NAME".
struct SceneModel {
    SurfaceModel surfaces;
    std::map<std::string, Pose> siteFromObject;
};

/// Builds every object. ErrorCode::input when a measurement names a feature, or a handheld layer an object,
/// that the scene does not have.
Result<SceneModel> buildScene(const SceneSpec& spec, std::uint64_t seed);

}  // namespace vestige
