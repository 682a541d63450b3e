#include "ui/actions/reactions/CleaningReactions.h"

#include "core/scene/CleaningEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/reactions/FindParts.h"
#include "ui/document/CleaningSettings.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

using Mode = PointSelection::Mode;
constexpr std::size_t kMostObjects = 200;

const SceneObject* objectOf(const SceneState& scene, const std::string& name) {
    for (const SceneObject& object : scene.objects)
        if (object.name == name) return &object;
    return nullptr;
}

/// Whether the program has named it, and nobody since.
bool isOwnName(const SceneObject& object) {
    const std::string stem = nameOfKind(object.kind) + " ";
    return object.found.rfind("separated", 0) == 0 && object.name.rfind(stem, 0) == 0 &&
           object.name.find_first_not_of("0123456789", stem.size()) == std::string::npos;
}

}  // namespace

CleaningReactions::CleaningReactions(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench) {
    auto& actions = bench_.actions;
    actions.onTriggered("clean.remove", [this] { removeSelected(); });
    actions.onTriggered("clean.keep", [this] { keepSelected(); });
    actions.onTriggered("clean.invert", [this] {
        const PointSelection::Sets others = bench_.points.others();
        bench_.points.setReach(std::nullopt);
        bench_.points.setBehind(0);
        CleaningStep step = bench_.points.step();
        step.how = "all but " + (step.how.empty() ? "nothing" : step.how);
        bench_.points.apply(others, Mode::replace, std::move(step));
    });
    actions.onTriggered("clean.clear", [this] { bench_.points.clear(); });
    actions.onTriggered("clean.restore", [this] { bringBack(); });
    actions.onTriggered("clean.make-object", [this] { makeObject(); });
    actions.onTriggered("clean.outliers", [this] { findOutliers(); });
    actions.onTriggered("clean.ground", [this] { findGround(); });
    actions.onTriggered("clean.objects", [this] { separateObjects(); });
    actions.onTriggered("part.select", [this] { selectObject(); });
    actions.onTriggered("part.zoom", [this] { lookAtObject(); });
    actions.onTriggered("part.remove",
                        [this] { bench_.document.perform(removeObject(bench_.points.object())); });
}

void CleaningReactions::removeSelected() {
    PointSelection::Sets sets;
    for (const Layer& layer : bench_.document.state().layers)
        if (const auto points = bench_.points.of(layer.id)) sets[layer.id] = *points;
    takeOut(sets, bench_.points.step().how, bench_.points.step().parameters);
}

void CleaningReactions::keepSelected() {
    PointSelection::Sets sets = bench_.points.others();
    // A layer of which nothing is selected has no part in this.
    std::erase_if(sets, [this](const auto& one) { return !bench_.points.of(one.first); });
    takeOut(sets, "all but " + bench_.points.step().how, bench_.points.step().parameters);
}

void CleaningReactions::takeOut(const PointSelection::Sets& sets, const std::string& how,
                                const std::string& parameters) {
    std::vector<std::pair<std::string, std::shared_ptr<const Cleaning>>> changes;
    std::size_t count = 0;
    for (const auto& [id, points] : sets) {
        const Layer* layer = bench_.document.state().layer(id);
        auto cleaning = withRemoved(*layer, points, {how.empty() ? "by hand" : how, parameters, 0});
        if (!cleaning) return bench_.notices.failed(cleaning.error());
        if (!*cleaning) continue;
        count += (*cleaning)->steps.back().points;
        changes.emplace_back(id, std::move(*cleaning));
    }
    if (changes.empty()) return tellNothing();
    const QString title = tr("remove %1 points").arg(countText(count));
    bench_.document.begin(title);
    for (auto& [id, cleaning] : changes)
        bench_.document.perform(setCleaning(id, std::move(cleaning), title.toStdString()));
    bench_.document.end();
    bench_.notices.inform(
        tr("%1 points are taken out of the scene; their files keep them. Undo brings them back.")
            .arg(countText(count)));
}

void CleaningReactions::bringBack() {
    const SceneState& scene = bench_.document.state();
    const Layer* selected = scene.layer(bench_.selection.layer());
    std::vector<std::string> ids;
    for (const Layer& layer : scene.layers)
        if (layer.cleaning && (!selected || !selected->cleaning || selected == &layer))
            ids.push_back(layer.id);
    bench_.document.begin(tr("bring removed points back"));
    for (const std::string& id : ids) bench_.document.perform(setCleaning(id, nullptr, "bring points back"));
    bench_.document.end();
}

std::vector<Layer> CleaningReactions::layersToSearch() const {
    std::vector<Layer> layers;
    for (const Layer& layer : bench_.document.state().layers) {
        if (!loadedData(layer)) continue;
        if (layer.id == bench_.selection.layer()) return {layer};
        if (layer.visible) layers.push_back(layer);
    }
    return layers;
}

const Layer* CleaningReactions::layerToSeparate() const {
    const SceneState& scene = bench_.document.state();
    for (const std::string& id : {bench_.selection.layer(), scene.target})
        if (const Layer* layer = scene.layer(id); layer && loadedData(*layer)) return layer;
    for (const Layer& layer : scene.layers)
        if (loadedData(layer)) return &layer;
    return nullptr;
}

void CleaningReactions::tellNothing() {
    bench_.notices.inform(tr("No points are selected that are still in the scene."));
}

void CleaningReactions::findOutliers() {
    const auto layers = layersToSearch();
    if (layers.empty()) return bench_.notices.inform(tr("No layer is loaded and shown."));
    bench_.jobs.run<PointSelection::Sets>(
        tr("Finding outliers"),
        [layers, settings = bench_.cleaning.outliers](const JobControl& control) {
            return outliersOf(layers, settings, control);
        },
        [this, words = describe(bench_.cleaning.outliers)](Result<PointSelection::Sets> found) {
            if (!found) return bench_.notices.failed(found.error());
            bench_.points.setReach(std::nullopt);
            bench_.points.setBehind(0);
            bench_.points.apply(*found, Mode::replace, {"outliers", words, 0});
            bench_.notices.inform(
                tr("%1 outliers are selected; Delete takes them out.").arg(countText(bench_.points.size())));
        });
}

void CleaningReactions::findGround() {
    const Layer* layer = layerToSeparate();
    if (!layer) return bench_.notices.inform(tr("No layer is loaded."));
    bench_.jobs.run<PointSelection::Sets>(
        tr("Finding the ground of %1").arg(QString::fromStdString(layer->name)),
        [layer = *layer, settings = bench_.cleaning.ground](const JobControl& control) {
            return groundOf(layer, settings, control);
        },
        [this, words = describe(bench_.cleaning.ground)](Result<PointSelection::Sets> found) {
            if (!found) return bench_.notices.failed(found.error());
            bench_.points.setReach(std::nullopt);
            bench_.points.setBehind(0);
            bench_.points.apply(*found, Mode::replace, {"ground", words, 0});
            bench_.notices.inform(
                tr("%1 points of the ground are selected.").arg(countText(bench_.points.size())));
        });
}

void CleaningReactions::separateObjects() {
    const Layer* layer = layerToSeparate();
    if (!layer) return bench_.notices.inform(tr("No layer is loaded."));
    using Objects = std::vector<SceneObject>;
    bench_.jobs.run<Objects>(
        tr("Separating what stands on the ground of %1").arg(QString::fromStdString(layer->name)),
        [layer = *layer, ground = bench_.cleaning.ground, objects = bench_.cleaning.objects](
            const JobControl& control) { return objectsOf(layer, ground, objects, control); },
        [this, id = layer->id](Result<Objects> found) {
            if (!found) return bench_.notices.failed(found.error());
            const Layer* now = bench_.document.state().layer(id);
            if (!now) return;
            const std::size_t all = found->size();
            if (all > kMostObjects) found->resize(kMostObjects);
            bench_.document.begin(tr("separate objects of %1").arg(QString::fromStdString(now->name)));
            const std::vector<SceneObject> before = bench_.document.state().objects;
            for (const SceneObject& old : before)
                if (old.layer == id && isOwnName(old)) bench_.document.perform(removeObject(old.name));
            for (SceneObject& object : *found) {
                int number = 1;
                while (
                    objectOf(bench_.document.state(), nameOfKind(object.kind) + " " + std::to_string(number)))
                    ++number;
                object.name = nameOfKind(object.kind) + " " + std::to_string(number);
                bench_.document.perform(addObject(std::move(object)));
            }
            bench_.document.end();
            bench_.notices.inform(
                all == 0 ? tr("Nothing of the sizes asked for stands on the ground.")
                : all > kMostObjects
                    ? tr("The %1 largest of %2 objects are listed; smaller limits give fewer.")
                          .arg(kMostObjects)
                          .arg(all)
                    : tr("%1 objects are listed at the left.").arg(all));
        });
}

void CleaningReactions::makeObject() {
    std::vector<std::pair<Layer, std::shared_ptr<const PointSet>>> parts;
    for (const Layer& layer : bench_.document.state().layers)
        if (const auto points = bench_.points.of(layer.id)) parts.emplace_back(layer, points);
    if (parts.empty()) return tellNothing();
    using Objects = std::vector<SceneObject>;
    bench_.jobs.run<Objects>(
        tr("Making an object"),
        [parts, step = bench_.points.step()](const JobControl&) -> Result<Objects> {
            Objects objects;
            for (const auto& [layer, points] : parts)
                objects.push_back(objectFrom(
                    layer, points, step.how + (step.parameters.empty() ? "" : ": " + step.parameters)));
            return objects;
        },
        [this](Result<Objects> made) {
            if (!made) return bench_.notices.failed(made.error());
            bench_.document.begin(tr("make an object"));
            std::string last;
            for (SceneObject& object : *made) {
                int number = 1;
                while (objectOf(bench_.document.state(), "Object " + std::to_string(number))) ++number;
                object.name = last = "Object " + std::to_string(number);
                bench_.document.perform(addObject(std::move(object)));
            }
            bench_.document.end();
            bench_.points.clear();
            bench_.points.setObject(last);
            emit objectMade(last);
        });
}

void CleaningReactions::selectObject() {
    const SceneObject* object = objectOf(bench_.document.state(), bench_.points.object());
    if (!object) return;
    const Layer* layer = bench_.document.state().layer(object->layer);
    if (!layer || !belongsTo(*object, *layer))
        return bench_.notices.inform(
            tr("%1 is of points that are not loaded.").arg(QString::fromStdString(object->name)));
    bench_.points.setReach(std::nullopt);
    bench_.points.setBehind(0);
    bench_.points.apply({{object->layer, *object->points}}, Mode::replace, {object->name, object->found, 0});
}

void CleaningReactions::lookAtObject() {
    const SceneObject* object = objectOf(bench_.document.state(), bench_.points.object());
    const Layer* layer = object ? bench_.document.state().layer(object->layer) : nullptr;
    if (!layer || !belongsTo(*object, *layer)) return;
    emit boxWanted(boundsOf(*layer, *object->points));
}

}  // namespace vestige
