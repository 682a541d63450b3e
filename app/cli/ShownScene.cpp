#include "app/cli/ShownScene.h"

#include <algorithm>
#include <filesystem>

#include "core/pipeline/DescribeView.h"
#include "core/pipeline/LoadLayers.h"
#include "core/pipeline/MeasurementMarks.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/pipeline/RegisterTogether.h"
#include "core/pipeline/ResolveAims.h"
#include "core/pipeline/TargetDistances.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "core/scene/LayerUnit.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/PickFrame.h"

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

Status load(SceneState& scene, const FilePart& part, const JobControl& control) {
    const double count = static_cast<double>(scene.layers.size());
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        Layer& layer = scene.layers[i];
        if (part.every > 1) layer.keepEvery = part.every;
        if (part.box) layer.box = part.box;
        layer.salvage = layer.salvage || part.salvage;
        const double share = static_cast<double>(i);
        auto data =
            loadLayer(layer, scene.resolve(layer.path), control.sub(share / count, (share + 1) / count));
        if (!data) return fail(data.error());
        layer.data = std::move(*data);
        if (const auto difference = evidenceDifference(layer)) control.message("warning: " + *difference);
    }
    return {};
}

/// A layer that cannot be registered ends an overlay that compares layers (`must`); else it is told and left
/// out.
Status registerWhatLacks(SceneState& scene, bool must, const Session& session, const JobControl& control) {
    std::vector<std::string> open;
    for (const Layer& layer : scene.layers)
        if (!layer.registration && needsRegistration(scene, layer)) open.push_back(layer.id);
    auto attempted = attemptLayers(scene, open, control);
    if (!attempted) {
        if (must || attempted.error().code == ErrorCode::cancelled) return fail(attempted.error());
        session.log("warning: " + attempted.error().sentence());
        return {};
    }
    for (AttemptedLayer& one : attempted->layers) {
        if (one.failure) {
            if (must) return fail(*one.failure);
            session.log("warning: " + one.failure->sentence());
            continue;
        }
        Layer& layer = *scene.layer(one.id);
        for (const std::string& note : one.result->notes) session.log(layer.id + ": " + note);
        noteUnit(layer, one.result->targetFromSource.scale);
        setRegistration(one.id, std::move(*one.result))->apply(scene);
    }
    return {};
}

/// A cloud in a frame of its own has no place in the picture of the scene.
void hideUnplaced(SceneState& scene, const Session& session) {
    for (Layer& layer : scene.layers) {
        if (!layer.visible || isPlaced(scene, layer)) continue;
        layer.visible = false;
        session.log(layer.id + " is not registered to " + scene.target + " and is left out of the picture");
    }
}

/// The lengths measured on what is shown.
std::vector<ViewMark> marksOf(SceneState& scene, const JobControl& control) {
    scene.measurements = resolveAims(scene, control);
    std::vector<ViewMark> marks;
    for (const MeasuredLength& length : measureScene(scene).lengths) {
        const bool shown =
            std::all_of(length.layers.begin(), length.layers.end(), [&](const std::string& id) {
                const Layer* layer = scene.layer(id);
                return layer && layer->visible;
            });
        if (!shown) continue;
        if (auto mark = measurementMark(scene, length)) marks.push_back(std::move(*mark));
    }
    return marks;
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

Result<ShownScene> shownScene(const std::vector<std::string>& inputs, const FilePart& part, Overlay overlay,
                              const std::string& color, const Session& session, const JobControl& control) {
    return guarded(inputs.front(), [&]() -> Result<ShownScene> {
        Result<SceneState> scene = sceneOf(inputs, session);
        if (!scene) return fail(scene.error());
        const bool isCase = looksLikeCase(inputs.front());
        if (const Status loaded = load(*scene, part, control.sub(0, 0.5)); !loaded)
            return fail(loaded.error());
        const bool compares = overlay == Overlay::registration || overlay == Overlay::residual;
        if (isCase) {
            const Status done = registerWhatLacks(*scene, compares, session, control.sub(0.5, 1));
            if (!done) return fail(done.error());
            hideUnplaced(*scene, session);
        }
        ViewDescription view = describeView(*scene, ColorMode::height, overlay);
        if (isCase) hideObjects(view, *scene);
        view.colorMode = colorOf(view, color);
        if (!isCase && overlay == Overlay::residual) addResiduals(view, *scene);
        if (isCase) view.marks = marksOf(*scene, control);
        return ShownScene{std::move(view), scene->savedViews, knowsNorth(*scene)};
    });
}

}  // namespace vestige::cli
