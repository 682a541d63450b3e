#pragma once

#include <filesystem>
#include <string>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Reads a case.json (or a saved case, which is the same format with more keys: registrations, views, aims,
/// visibility; a folder NAME.vestige holds it as case.json). Layers are named, not loaded. ErrorCode::input
/// names the file and the JSON path ("layers[1].unit") and what was expected.
Result<SceneState> readCase(const std::filesystem::path& file);

/// Writes it so that readCase gives the same scene; numbers exactly; layer paths relative to `file`. Atomic.
Status writeCase(const std::filesystem::path& file, const SceneState& scene);

/// True for NAME.vestige folders and files and for *.json: what `reconstruct`, `screenshot` and the window
/// open as a case.
bool looksLikeCase(const std::filesystem::path& path);

}  // namespace vestige
