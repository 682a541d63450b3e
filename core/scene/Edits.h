#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/Scene.h"

namespace vestige {

/// The changes that window and pipeline make, one file each under edits/.

/// Changes nothing when the id is empty or taken. The first layer of a scene without any becomes the target.
std::unique_ptr<SceneEdit> addLayer(Layer layer);
/// The target's removal leaves the scene without one. Picks on the layer stay.
std::unique_ptr<SceneEdit> removeLayer(std::string id);
/// Replaces the layer of the same id (name, role, unit, init, tint, visibility, ...), keeping nothing of the
/// old one but its loaded data where the path stays. Picks stay on the layer's points.
std::unique_ptr<SceneEdit> changeLayer(Layer layer, std::string description);
std::unique_ptr<SceneEdit> setLayerVisible(std::string id, bool visible);
/// Picks made on the layer move along with it (PickFrame.h); those a case file gave for a layer that was not
/// registered yet are in the target's frame already and stay.
std::unique_ptr<SceneEdit> setRegistration(std::string layer, std::optional<RegistrationResult> result);
/// Drops all registrations: they were to the old target.
std::unique_ptr<SceneEdit> setTarget(std::string layer);
std::unique_ptr<SceneEdit> setPreprocessParameter(std::string key, ParameterValue value);
std::unique_ptr<SceneEdit> setRegistrationParameter(std::string key, ParameterValue value);
/// Adds, or replaces the one of the same object.
std::unique_ptr<SceneEdit> setMeasurement(Measurement measurement, std::string description);
std::unique_ptr<SceneEdit> removeMeasurement(std::string object);
/// Changes nothing when the new name is empty or taken.
std::unique_ptr<SceneEdit> renameMeasurement(std::string object, std::string newName);
/// One repetition more under `layer` (the key of the picks). Changes nothing when there is no such object.
std::unique_ptr<SceneEdit> addPick(std::string object, std::string layer, PickedPair pair);
std::unique_ptr<SceneEdit> removePick(std::string object, std::string layer, std::size_t repeat);
/// Puts `point` in the place of one end of a repetition (`second`: the pair's b). Changes nothing when there
/// is no such repetition, or the end is the same already.
std::unique_ptr<SceneEdit> movePick(std::string object, std::string layer, std::size_t repeat, bool second,
                                    PickedPoint point);
/// Metres above 0, or nothing; anything else changes nothing.
std::unique_ptr<SceneEdit> setTape(std::string object, std::optional<double> tape_m);
std::unique_ptr<SceneEdit> setCaseDetails(std::string name, std::string operatorName,
                                          std::optional<Site> site);
/// A view in scene metres, bound to no layer.
std::unique_ptr<SceneEdit> setView(std::string name, ViewCamera camera);
std::unique_ptr<SceneEdit> removeView(std::string name);
/// Puts a whole case in place of the present one, as one step; its place (SceneState::file) and what is
/// loaded of the files that both name stay.
std::unique_ptr<SceneEdit> restoreState(SceneState state, std::string description);

/// `wanted`, or with -2, -3, ... what no layer of the scene is called yet.
std::string unusedLayerId(const SceneState& scene, const std::string& wanted);

}  // namespace vestige
