#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/scene/Cleaning.h"
#include "core/scene/Scene.h"
#include "core/scene/casefile/JsonCursor.h"

namespace vestige {

/// How paths are written: relative to the case file, or as they are.
using PathText = std::function<std::string(const std::filesystem::path&)>;

/// The scene as a case file has it, keys in the order of the contract.
nlohmann::ordered_json caseJson(const SceneState& scene, const PathText& pathText);
nlohmann::ordered_json layerJson(const Layer& layer, const PathText& pathText);
nlohmann::ordered_json resultJson(const RegistrationResult& result);
nlohmann::ordered_json measurementJson(const Measurement& measurement);
nlohmann::ordered_json viewJson(const ViewCamera& camera, const std::string& frame);
nlohmann::ordered_json poseJson(const Pose& pose);
nlohmann::ordered_json cleaningJson(const Cleaning& cleaning);
nlohmann::ordered_json objectJson(const SceneObject& object);

/// The same back; ErrorException names file and path of what is wrong. `folder` is that of the case file.
void readCaseJson(const JsonCursor& root, const std::filesystem::path& folder, SceneState& scene);
Layer readLayer(const JsonCursor& layer, std::size_t place, const std::filesystem::path& folder);
RegistrationResult readResult(const JsonCursor& result);
RegistrationQuality readQuality(const JsonCursor& quality);
Measurement readMeasurement(const JsonCursor& measurement);
ViewCamera readView(const JsonCursor& view);
Pose readPose(const JsonCursor& pose);
std::shared_ptr<const Cleaning> readCleaning(const JsonCursor& cleaning);
SceneObject readObject(const JsonCursor& object);

/// Text of a JSON tree of ours: what fits into a line stands in one line.
std::string prettyText(const nlohmann::ordered_json& tree);

/// Whether two would be written the same, loaded data aside.
bool sameText(const Layer& a, const Layer& b);
bool sameText(const RegistrationResult& a, const RegistrationResult& b);

}  // namespace vestige
