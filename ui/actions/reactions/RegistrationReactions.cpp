#include "ui/actions/reactions/RegistrationReactions.h"

#include "core/pipeline/RegisterLayers.h"
#include "core/pipeline/ResolveAims.h"
#include "core/scene/Edits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Presentation.h"
#include "ui/document/Selection.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

struct Found {
    std::string layer;
    RegistrationResult result;
};

Result<std::vector<Found>> registerAll(const SceneState& scene, const std::vector<std::string>& layers,
                                       const JobControl& control) {
    std::vector<Found> found;
    const double count = static_cast<double>(layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        auto result =
            registerLayer(scene, layers[i],
                          control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
        if (!result) return fail(result.error());
        found.push_back({layers[i], std::move(*result)});
    }
    return found;
}

QString namesOf(const SceneState& scene, const std::vector<std::string>& layers) {
    QStringList names;
    for (const std::string& id : layers)
        if (const Layer* layer = scene.layer(id)) names << QString::fromStdString(layer->name);
    return names.join(", ");
}

bool hasAims(const SceneState& scene) {
    for (const Measurement& measurement : scene.measurements)
        if (!measurement.aims.empty()) return true;
    return false;
}

}  // namespace

RegistrationReactions::RegistrationReactions(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench) {
    auto& actions = bench_.actions;
    actions.onTriggered("register.run", [this] { registerLayers(); });
    actions.onTriggered("register.clear", [this] {
        bench_.document.perform(setRegistration(bench_.selection.layer(), std::nullopt));
    });
    actions.onTriggered("measure.aims", [this] { resolveRecordedAims(); });
}

std::vector<std::string> RegistrationReactions::layersToRegister() const {
    const SceneState& scene = bench_.document.state();
    std::vector<std::string> open, all;
    for (const Layer& layer : scene.layers) {
        if (layer.id == scene.target || !layer.data) continue;
        if (layer.id == bench_.selection.layer()) return {layer.id};
        all.push_back(layer.id);
        if (!layer.registration && needsRegistration(scene, layer)) open.push_back(layer.id);
    }
    return open.empty() ? all : open;
}

void RegistrationReactions::registerLayers() {
    const auto layers = layersToRegister();
    if (layers.empty()) return;
    const QString names = namesOf(bench_.document.state(), layers);
    using FoundAll = std::vector<Found>;
    bench_.jobs.run<FoundAll>(
        tr("Registering %1").arg(names),
        [scene = bench_.document.state(), layers](const JobControl& control) {
            return registerAll(scene, layers, control);
        },
        [this, names](Result<FoundAll> found) {
            if (!found) return bench_.notices.failed(found.error());
            bench_.document.begin(tr("register %1").arg(names));
            for (Found& one : *found) enter(one.layer, std::move(one.result));
            bench_.document.end();
            bench_.presentation.setBefore(false);
            bench_.presentation.setOverlay(Overlay::registration);
            if (hasAims(bench_.document.state())) resolveRecordedAims();
        });
}

void RegistrationReactions::enter(const std::string& id, RegistrationResult result) {
    const SceneState& scene = bench_.document.state();
    const Layer* layer = scene.layer(id);
    if (!layer) return;  // removed while it was being registered
    if (!needsRegistration(scene, *layer)) {
        // Asked for by hand; with a first pose the report registers it as well.
        Layer changed = *layer;
        changed.init = InitPose{result.initial};
        bench_.document.perform(changeLayer(std::move(changed), "first pose of " + layer->name));
    }
    bench_.document.perform(setRegistration(id, std::move(result)));
}

void RegistrationReactions::resolveRecordedAims() {
    using Measurements = std::vector<Measurement>;
    bench_.jobs.run<Measurements>(
        tr("Taking recorded aims"),
        [scene = bench_.document.state()](const JobControl& control) -> Result<Measurements> {
            auto resolved = resolveAims(scene, control);
            if (control.cancelled()) return fail(cancelledError());
            return resolved;
        },
        [this](Result<Measurements> resolved) {
            if (!resolved) return bench_.notices.failed(resolved.error());
            bench_.document.begin(tr("take recorded aims"));
            for (Measurement& measurement : *resolved) {
                std::string description = "aims of " + measurement.object;
                bench_.document.perform(setMeasurement(std::move(measurement), std::move(description)));
            }
            bench_.document.end();
        });
}

}  // namespace vestige
