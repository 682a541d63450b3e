#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Reads a case.json (or a saved case, which is the same format with more keys: registrations, views, aims,
/// visibility; a folder holds it as case.json), or a store NAME.vestige as it was saved last
/// (store/CaseStore.h). Layers are named, not loaded; their paths come back absolute. ErrorCode::input
/// names the file and the JSON path ("layers[1].unit") and what was expected. Keys that Vestige does
/// not know are no error: each gives a sentence in `warnings`; so do edits that a store holds unsaved,
/// unless the caller has its own way with them.
enum class UnsavedEdits { told, passedOver };
Result<SceneState> readCase(const std::filesystem::path& file, std::vector<std::string>* warnings = nullptr,
                            UnsavedEdits unsaved = UnsavedEdits::told);

/// Writes it so that readCase gives the same scene; numbers exactly; layer paths relative to the JSON file.
/// Atomic and durable. ErrorCode::output on failure. NAME.vestige becomes a store; ErrorCode::output, too,
/// when somebody has it open.
Status writeCase(const std::filesystem::path& file, const SceneState& scene);

/// True for NAME.vestige folders and files and for *.json, except a 3D Tiles tileset, which is a cloud: what
/// `reconstruct`, `screenshot` and the window open as a case.
bool looksLikeCase(const std::filesystem::path& path);

/// True for NAME.vestige unless a file stands there: the folder of a store, even if it is yet to be made.
bool isCaseStore(const std::filesystem::path& path);

/// The JSON file of a case: `path` itself, or case.json in it for a folder and for a NAME.vestige that is yet
/// to be made. In a store it is a readable copy.
std::filesystem::path caseJsonPath(const std::filesystem::path& path);

/// One name for every way to name a case: the store's folder, or the JSON file; absolute, links resolved.
std::filesystem::path casePlace(const std::filesystem::path& path);

/// The file that holds what readCase reads, and the SHA-256 of that text.
Result<std::pair<std::filesystem::path, std::string>> caseContent(const std::filesystem::path& file);

/// The text that writeCase writes, with the paths as they are in memory: equal texts mean equal documents
/// (loaded data aside).
std::string caseText(const SceneState& scene);

}  // namespace vestige
