#include "app/cli/ShownScene.h"

#include <algorithm>
#include <filesystem>

#include "core/pipeline/DescribeView.h"
#include "core/pipeline/LoadLayers.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/pipeline/ResolveAims.h"
#include "core/pipeline/TargetDistances.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "core/scene/MeasuredScene.h"

namespace vestige::cli {
namespace {

Result<SceneState> sceneOf(const std::vector<std::string>& inputs, const Session& session) {
    const auto isCase = [](const std::string& input) { return looksLikeCase(input); };
    if (std::any_of(inputs.begin(), inputs.end(), isCase)) {
        if (inputs.size() > 1)
            return fail(ErrorCode::usage, "a case is shown alone", inputs.front(),
                        "give one case, or clouds and meshes");
        std::vector<std::string> warnings;
        auto scene = readCase(inputs.front(), &warnings);
        for (const std::string& warning : warnings) session.log("warning: " + warning);
        return scene;
    }
    SceneState scene;
    for (const std::string& input : inputs) {
        Layer layer;
        layer.path = input;
        layer.id = unusedLayerId(scene, layer.path.stem().string());
        layer.name = layer.path.filename().string();
        layer.tint = defaultTint(scene.layers.size());
        if (scene.target.empty()) scene.target = layer.id;
        scene.layers.push_back(std::move(layer));
    }
    return scene;
}

Status load(SceneState& scene, const JobControl& control) {
    const double count = static_cast<double>(scene.layers.size());
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        Layer& layer = scene.layers[i];
        const double share = static_cast<double>(i);
        auto data = loadLayerData(scene.resolve(layer.path), control.sub(share / count, (share + 1) / count));
        if (!data) return fail(data.error());
        layer.data = std::move(*data);
    }
    return {};
}

bool lacksRegistration(const SceneState& scene, const Layer& layer) {
    return !layer.registration && needsRegistration(scene, layer);
}

Status registerWhatLacks(SceneState& scene, const Session& session, const JobControl& control) {
    for (Layer& layer : scene.layers) {
        if (!lacksRegistration(scene, layer)) continue;
        auto result = registerLayer(scene, layer.id, control);
        if (!result) return fail(result.error());
        for (const std::string& note : result->notes) session.log(layer.id + ": " + note);
        if (!layer.unit)
            layer.unit = result->targetFromSource.scale == 1 ? LengthUnit::metre : LengthUnit::millimetre;
        setRegistration(layer.id, std::move(*result))->apply(scene);
    }
    return {};
}

/// The measured lengths as marks; what was only aimed at is picked when every layer stands in its place.
std::vector<ViewMark> marksOf(SceneState& scene, const JobControl& control) {
    const bool placed = std::none_of(scene.layers.begin(), scene.layers.end(),
                                     [&](const Layer& layer) { return lacksRegistration(scene, layer); });
    if (placed) scene.measurements = resolveAims(scene, control);
    return measurementMarks(scene, measureScene(scene));
}

/// Distances of files that simply lie where they lie.
void addResiduals(ViewDescription& view, const SceneState& scene) {
    const Layer* target = scene.layer(scene.target);
    if (!target || !target->data) return;
    for (ViewLayer& shown : view.layers) {
        const Layer* layer = scene.layer(shown.id);
        if (shown.isTarget || shown.residual_m || !layer) continue;
        shown.residual_m = std::make_shared<const std::vector<float>>(targetDistances(
            *target->data->octree, sceneFromLayer(*target), *layer->data->points, shown.worldFromLayer));
    }
}

ColorMode colorOf(const ViewDescription& view, const std::string& color) {
    if (const auto mode = colorModeFromName(color)) return *mode;
    const bool colored = std::any_of(view.layers.begin(), view.layers.end(), [](const ViewLayer& layer) {
        return !layer.geometry->vertices.attributes().color.empty();
    });
    return colored ? ColorMode::rgb : ColorMode::height;
}

}  // namespace

Result<ViewDescription> shownScene(const std::vector<std::string>& inputs, Overlay overlay,
                                   const std::string& color, const Session& session,
                                   const JobControl& control) {
    return guarded(inputs.front(), [&]() -> Result<ViewDescription> {
        Result<SceneState> scene = sceneOf(inputs, session);
        if (!scene) return fail(scene.error());
        const bool isCase = looksLikeCase(inputs.front());
        if (const Status loaded = load(*scene, control.sub(0, 0.5)); !loaded) return fail(loaded.error());
        const bool compares = overlay == Overlay::registration || overlay == Overlay::residual;
        if (isCase && compares)
            if (const Status done = registerWhatLacks(*scene, session, control.sub(0.5, 1)); !done)
                return fail(done.error());
        ViewDescription view = describeView(*scene, ColorMode::height, overlay);
        view.colorMode = colorOf(view, color);
        if (!isCase && overlay == Overlay::residual) addResiduals(view, *scene);
        if (isCase) view.marks = marksOf(*scene, control);
        return view;
    });
}

}  // namespace vestige::cli
