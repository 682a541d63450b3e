#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scene/Scene.h"

namespace vestige {

/// The registration of every layer that has one, as registration.json and `reconstruct --json` list them:
/// registrationJson() with "layer" and "via", the layers it was registered to.
nlohmann::json registrationsJson(const SceneState& scene, bool withSeconds);

}  // namespace vestige
