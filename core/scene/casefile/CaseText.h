#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// A case with a thousand measurements is 2 MB and 40 000 values, the ground taken out of ten million points
/// 5 MB; the limit keeps a hostile file from filling the memory.
constexpr std::size_t kLargestCaseText = std::size_t{64} << 20;

/// The scene that the text of a case file tells. `place` names the file in errors, `folder` is what its paths
/// are relative to. Errors and warnings as readCase's.
Result<SceneState> sceneFromText(const std::string& text, const std::string& place,
                                 const std::filesystem::path& folder,
                                 std::vector<std::string>* warnings = nullptr);

/// The text of a case file in `folder` (absolute): pretty, layer paths relative to it. ErrorCode::output for
/// one that could not be read back because of its size.
Result<std::string> textInFolder(const SceneState& scene, const std::filesystem::path& folder);

}  // namespace vestige
