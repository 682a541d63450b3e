#pragma once

#include <memory>
#include <string>

#include "core/scene/Scene.h"

namespace vestige {

/// Adds a view at the end, or replaces the one of the same name in its place. Nothing for an empty name.
std::unique_ptr<SceneEdit> setSavedView(SavedView view);
std::unique_ptr<SceneEdit> removeSavedView(std::string name);
/// Changes nothing when the new name is empty or taken.
std::unique_ptr<SceneEdit> renameSavedView(std::string name, std::string newName);

/// Null when the scene has no view of that name.
const SavedView* savedView(const SceneState& scene, std::string_view name);
/// "View 1", "View 2", ...: the first that no saved view is called.
std::string unusedViewName(const SceneState& scene);

}  // namespace vestige
