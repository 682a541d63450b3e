#include "ui/actions/reactions/RegistrationReactions.h"

#include <QSignalBlocker>

#include "core/base/Translation.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/pipeline/RegisterTogether.h"
#include "core/pipeline/ResolveAims.h"
#include "core/scene/CleanedData.h"
#include "core/scene/Edits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Attempts.h"
#include "ui/document/Comparison.h"
#include "ui/document/Document.h"
#include "ui/document/FitTrace.h"
#include "ui/document/Notices.h"
#include "ui/document/Presentation.h"
#include "ui/document/Preview.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

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
    actions.onTriggered("register.auto", [this] { registerLayers(InitAuto()); });
    actions.onTriggered("register.use-candidate", [this] { useCandidate(); });
    actions.onTriggered("register.step-back", [this] { stepReplay(-1); });
    actions.onTriggered("register.step-on", [this] { stepReplay(1); });
    actions.onToggled("register.preview", [this](bool on) {
        bench_.attempts.showPreview(described(), on);
        follow();
    });
    actions.onToggled("register.watch", [this](bool on) { watch_ = on; });
    actions.onTriggered("register.clear", [this] {
        bench_.document.perform(setRegistration(bench_.selection.layer(), std::nullopt));
    });
    actions.onTriggered("measure.aims", [this] { resolveRecordedAims(); });
    connect(&bench_.attempts, &Attempts::changed, this, [this] { follow(); });
    connect(&bench_.selection, &Selection::changed, this, [this] { follow(); });
}

std::string RegistrationReactions::described() const {
    const ShownFit fit = shownFit(bench_.document, bench_.selection, bench_.attempts);
    return fit.layer ? fit.layer->id : std::string();
}

void RegistrationReactions::stepReplay(int direction) {
    const std::string layer = described();
    const std::size_t count = bench_.trace.steps(layer).size();
    if (count == 0) return bench_.notices.inform(tr("Its iterations were not watched (W)."));
    const std::size_t now = bench_.trace.cursor(layer).value_or(count - 1);
    if (direction > 0 || now > 0) bench_.trace.replay(layer, now + direction);
}

void RegistrationReactions::follow() {
    QAction& action = bench_.actions["register.preview"];
    const QSignalBlocker quiet(action);
    action.setChecked(bench_.attempts.previewed(described()));
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

void RegistrationReactions::registerLayers(const std::optional<InitialPoseSpec>& start) {
    const auto layers = layersToRegister();
    if (!layers.empty()) run(layers, start);
}

void RegistrationReactions::useCandidate() {
    const std::string layer = described();
    const RegistrationResult* refused = bench_.attempts.of(layer);
    if (refused && !refused->candidates.empty()) run({layer}, InitPose{bench_.attempts.pose(layer)});
}

void RegistrationReactions::run(const std::vector<std::string>& layers,
                                const std::optional<InitialPoseSpec>& start) {
    SceneState scene = bench_.document.state();
    if (start)
        for (const std::string& id : layers) scene.layer(id)->init = *start;
    const QString names = namesOf(scene, layers);
    bench_.preview.end();
    FitTrace::Watches watches;
    if (watch_) {
        bench_.comparison.setMode(std::nullopt);
        bench_.presentation.setOverlay(Overlay::registration);
        bench_.actions["view.panel-fit"].trigger();
        watches = bench_.trace.begin();
    }
    bench_.jobs.run<AttemptedLayers>(
        tr("Registering %1").arg(names),
        [scene = std::move(scene), layers, watches](const JobControl& control) -> Result<AttemptedLayers> {
            SceneState cleaned = scene;
            if (const Status applied = applyCleaning(cleaned, control.sub(0, 0)); !applied)
                return fail(applied.error());
            return attemptLayers(cleaned, layers, control, watches);
        },
        [this, names, start](Result<AttemptedLayers> all) {
            bench_.trace.finish();
            if (!all) return bench_.notices.failed(all.error());
            bench_.document.begin("register " + names);
            QStringList sentences;
            bool entered = false;
            for (AttemptedLayer& one : all->layers) {
                const bool found = one.result && one.result->trustworthy();
                const QString said = take(one.id, std::move(one.result), start);
                if (!said.isEmpty()) sentences << said;
                entered = entered || found;
            }
            bench_.document.end();
            if (!sentences.isEmpty()) emit bench_.notices.warned(sentences.join("\n"));
            bench_.presentation.setBefore(false);
            if (entered) bench_.presentation.setOverlay(Overlay::registration);
            if (entered && hasAims(bench_.document.state())) resolveRecordedAims();
        });
}

QString RegistrationReactions::take(const std::string& id, Result<RegistrationResult> result,
                                    const std::optional<InitialPoseSpec>& start) {
    const Layer* layer = bench_.document.state().layer(id);
    if (!layer) return {};  // removed while it was being registered
    const QString name = QString::fromStdString(layer->name);
    if (!result) {
        const Error& error = result.error();
        // Its hint is for command lines.
        if (error.code == ErrorCode::untrustworthy)
            return tr("%1 was not registered: %2. Choose its start under Align, or Register from any pose "
                      "(Ctrl+Shift+G).")
                .arg(name, said(error.message));
        return tr("%1 was not registered: %2.").arg(name, QString::fromStdString(say(error)));
    }
    const QString reason =
        result->reasons.empty() ? QString() : tr(": %1").arg(said(result->reasons.front()));
    if (!result->trustworthy()) {
        const bool several = result->verdict == Verdict::ambiguous;
        bench_.attempts.set(id, std::move(*result));
        bench_.selection.setLayer(id);
        bench_.actions["view.panel-fit"].trigger();
        return several ? tr("%1 was not moved: several places fit alike. Choose one under Fit.").arg(name)
                       : tr("%1 was not moved, the registration failed%2. Fit shows what it found.")
                             .arg(name, reason);
    }
    const bool doubtful = result->verdict == Verdict::doubtful;
    bench_.attempts.forget(id);
    enter(id, std::move(*result), start);
    return doubtful ? tr("The registration of %1 is doubtful%2.").arg(name, reason) : QString();
}

void RegistrationReactions::enter(const std::string& id, RegistrationResult result,
                                  const std::optional<InitialPoseSpec>& start) {
    const SceneState& scene = bench_.document.state();
    const Layer* layer = scene.layer(id);
    if (start || !needsRegistration(scene, *layer)) {
        // Asked for by hand; with a first pose the report registers it as well.
        Layer changed = *layer;
        changed.init = start.value_or(InitPose{result.initial});
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
            bench_.document.begin("take recorded aims");
            for (Measurement& measurement : *resolved) {
                std::string description = "aims of " + measurement.object;
                bench_.document.perform(setMeasurement(std::move(measurement), std::move(description)));
            }
            bench_.document.end();
        });
}

}  // namespace vestige
