#include <algorithm>

#include "core/filters/Preprocess.h"
#include "core/registration/Register.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Scene.h"

namespace vestige {
namespace {

template <class Items, class Matches>
auto* findIn(Items& items, const Matches& matches) {
    const auto found = std::find_if(items.begin(), items.end(), matches);
    return found == items.end() ? nullptr : &*found;
}

}  // namespace

SceneState::SceneState() : preprocess(preprocessParameters()), registration(registrationParameters()) {}

const Layer* SceneState::layer(std::string_view id) const {
    return findIn(layers, [&](const Layer& layer) { return layer.id == id; });
}

Layer* SceneState::layer(std::string_view id) {
    return findIn(layers, [&](const Layer& layer) { return layer.id == id; });
}

const Measurement* SceneState::measurement(std::string_view object) const {
    return findIn(measurements, [&](const Measurement& measurement) { return measurement.object == object; });
}

Measurement* SceneState::measurement(std::string_view object) {
    return findIn(measurements, [&](const Measurement& measurement) { return measurement.object == object; });
}

std::filesystem::path SceneState::resolve(const std::filesystem::path& path) const {
    if (path.is_absolute() || path.empty()) return path;
    const auto folder = file.empty() ? std::filesystem::current_path()
                                     : std::filesystem::absolute(caseJsonPath(file)).parent_path();
    return (folder / path).lexically_normal();
}

}  // namespace vestige
