#include "core/pipeline/RegistrationsJson.h"

#include <nlohmann/json.hpp>

#include "core/registration/RegistrationJson.h"

namespace vestige {

nlohmann::json registrationsJson(const SceneState& scene, bool withSeconds) {
    nlohmann::json list = nlohmann::json::array();
    for (const Layer& layer : scene.layers) {
        if (!layer.registration) continue;
        nlohmann::json entry = registrationJson(*layer.registration, withSeconds);
        entry["layer"] = layer.id;
        entry["via"] = layer.registration->via.empty() ? std::vector{scene.target} : layer.registration->via;
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace vestige
