#include "ui/document/LayerDefaults.h"

#include <algorithm>
#include <cctype>

#include "core/base/UnitWords.h"
#include "core/registration/InitialPose.h"
#include "core/scene/LayerUnit.h"

namespace vestige {
namespace {

std::string idFrom(const std::string& stem) {
    std::string id;
    for (const char c : stem) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == '_' || c == '-')
            id += static_cast<char>(std::tolower(byte));
        else if (!id.empty() && id.back() != '-')
            id += '-';
    }
    return id.empty() ? "layer" : id;
}

}  // namespace

void tintApart(std::vector<Layer>& layers) {
    const auto given = Layer().tint;
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (layers[i].tint == given) layers[i].tint = defaultTint(i);
}

void nameLayers(std::vector<Layer>& layers, const SceneState& scene) {
    std::vector<std::string> taken;
    for (const Layer& layer : scene.layers) taken.push_back(layer.id);
    for (Layer& layer : layers) {
        const std::string stem = layer.path.stem().string();
        const std::string wanted = idFrom(stem);
        layer.id = wanted;
        for (int n = 2; std::ranges::find(taken, layer.id) != taken.end(); ++n)
            layer.id = wanted + "-" + std::to_string(n);
        layer.name = stem;
        const bool flown = layer.data && layer.data->info.format.starts_with("LA");
        layer.role = taken.empty() || flown ? LayerRole::aerial : LayerRole::handheld;
        layer.method = defaultMethod(layer.role);
        layer.tint = defaultTint(taken.size());
        taken.push_back(layer.id);
    }
}

std::vector<std::string> recogniseUnits(std::vector<Layer>& layers, const SceneState& scene) {
    std::vector<std::string> remarks;
    const Layer* target = scene.layer(scene.target);
    if (!target && !layers.empty()) target = &layers.front();
    if (!target || !target->data) return remarks;
    for (Layer& layer : layers) {
        if (layer.unit || !layer.data) continue;
        const std::optional<double> ofFile = fileMetresPerUnit(layer);
        if (&layer == target && !ofFile) continue;
        const UnitGuess guess =
            guessUnit(*target->data->geometry, target->metresPerUnit(), *layer.data->geometry, {}, ofFile);
        // A file with a unit of its own goes on saying it.
        if (ofFile) layer.unit = layer.fileUnit();
        if (guess.metresPerUnit == 1) continue;
        if (!ofFile) layer.unit = lengthUnitOf(guess.metresPerUnit);
        const std::string unit = unitWords(guess.metresPerUnit);
        remarks.push_back(ofFile ? layer.name + " is in " + unit + ", as its file says"
                                 : layer.name + " is taken to be in " + unit + ": " + guess.reason);
    }
    return remarks;
}

}  // namespace vestige
