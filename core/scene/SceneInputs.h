#pragma once

#include <filesystem>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// ErrorCode::usage where `output` is, by whatever name, a file that the scene's layers are read from: those
/// are only ever read.
Status isNoInput(const SceneState& scene, const std::filesystem::path& output);

}  // namespace vestige
