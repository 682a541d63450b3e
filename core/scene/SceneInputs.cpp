#include "core/scene/SceneInputs.h"

#include <variant>
#include <vector>

#include "core/base/AtomicFile.h"

namespace vestige {

Status isNoInput(const SceneState& scene, const std::filesystem::path& output) {
    const auto check = [&](const Layer& layer, const std::filesystem::path& input) -> Status {
        if (!samePlace(output, scene.resolve(input))) return {};
        return fail(ErrorCode::usage, "this would replace a file of the layer '" + layer.name + "'",
                    output.string(), "inputs are only ever read; expected: another name");
    };
    for (const Layer& layer : scene.layers) {
        std::vector<std::filesystem::path> inputs{layer.path};
        if (const auto* init = std::get_if<InitPicks>(&layer.init)) inputs.push_back(init->picks);
        if (layer.data)
            inputs.insert(inputs.end(), layer.data->info.companions.begin(),
                          layer.data->info.companions.end());
        for (const auto& input : inputs)
            if (Status apart = check(layer, input); !apart) return apart;
    }
    return {};
}

}  // namespace vestige
