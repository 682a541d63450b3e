#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/Scene.h"

namespace vestige {

/// The changes that window and pipeline make, one file each under edits/.
std::unique_ptr<SceneEdit> addLayer(Layer layer);
std::unique_ptr<SceneEdit> removeLayer(std::string id);
/// Replaces the layer of the same id (name, role, unit, init, tint, visibility, ...), keeping nothing of the
/// old one.
std::unique_ptr<SceneEdit> changeLayer(Layer layer, std::string description);
std::unique_ptr<SceneEdit> setLayerVisible(std::string id, bool visible);
std::unique_ptr<SceneEdit> setRegistration(std::string layer, std::optional<RegistrationResult> result);
std::unique_ptr<SceneEdit> setTarget(std::string layer);
std::unique_ptr<SceneEdit> setPreprocessParameter(std::string key, ParameterValue value);
std::unique_ptr<SceneEdit> setRegistrationParameter(std::string key, ParameterValue value);
/// Adds, or replaces the one of the same object.
std::unique_ptr<SceneEdit> setMeasurement(Measurement measurement, std::string description);
std::unique_ptr<SceneEdit> removeMeasurement(std::string object);
std::unique_ptr<SceneEdit> renameMeasurement(std::string object, std::string newName);
std::unique_ptr<SceneEdit> addPick(std::string object, std::string layer, PickedPair pair);
std::unique_ptr<SceneEdit> removePick(std::string object, std::string layer, std::size_t repeat);
std::unique_ptr<SceneEdit> setTape(std::string object, std::optional<double> tape_m);
std::unique_ptr<SceneEdit> setCaseDetails(std::string name, std::string operatorName,
                                          std::optional<Site> site);
std::unique_ptr<SceneEdit> setView(std::string name, ViewCamera camera);

}  // namespace vestige
