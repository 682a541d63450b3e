#pragma once

#include <memory>
#include <string>

#include "core/scene/Cleaning.h"
#include "core/scene/Scene.h"

namespace vestige {

/// What the layer is cleaned of from now on; null: nothing. Its data follow by a job (CleanedData.h).
std::unique_ptr<SceneEdit> setCleaning(std::string layer, std::shared_ptr<const Cleaning> cleaning,
                                       std::string description);
/// Changes nothing when the name is empty or taken, or the object has no points.
std::unique_ptr<SceneEdit> addObject(SceneObject object);
std::unique_ptr<SceneEdit> removeObject(std::string name);
/// Changes nothing when the new name is empty or taken.
std::unique_ptr<SceneEdit> renameObject(std::string name, std::string newName);
/// Changes nothing for a kind that is not one of objectKinds().
std::unique_ptr<SceneEdit> setObjectKind(std::string name, std::string kind);
std::unique_ptr<SceneEdit> setObjectVisible(std::string name, bool visible);

}  // namespace vestige
