#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Reads a case.json (or a saved case, which is the same format with more keys: registrations, views, aims,
/// visibility; a folder NAME.vestige holds it as case.json). Layers are named, not loaded; their
/// paths come back absolute. ErrorCode::input
/// names the file and the JSON path ("layers[1].unit") and what was expected. Keys that Vestige does
/// not know are no error: each gives a sentence in `warnings`.
Result<SceneState> readCase(const std::filesystem::path& file, std::vector<std::string>* warnings = nullptr);

/// Writes it so that readCase gives the same scene; numbers exactly; layer paths relative to `file`. Atomic.
/// ErrorCode::output on failure. For NAME.vestige the folder is made and case.json written into it.
Status writeCase(const std::filesystem::path& file, const SceneState& scene);

/// True for NAME.vestige folders and files and for *.json, except a 3D Tiles tileset, which is a cloud: what
/// `reconstruct`, `screenshot` and the window open as a case.
bool looksLikeCase(const std::filesystem::path& path);

/// The JSON file of a case: `path` itself, or case.json in it for a folder and for a NAME.vestige that is yet
/// to be made.
std::filesystem::path caseJsonPath(const std::filesystem::path& path);

/// The text that writeCase writes, with the paths as they are in memory: equal texts mean equal documents
/// (loaded data aside).
std::string caseText(const SceneState& scene);

}  // namespace vestige
