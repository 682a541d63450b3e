#include "ui/document/Evidence.h"

#include "core/base/Hash.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

using States = std::map<std::string, EvidenceState>;

Result<States> compare(const SceneState& scene, const JobControl& control) {
    States states;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const Layer& layer = scene.layers[i];
        if (!layer.data) continue;
        const double count = static_cast<double>(scene.layers.size());
        const auto step = control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        step.progress(0, "Hashing " + layer.path.filename().string());
        const auto now = sha256OfFile(scene.resolve(layer.path), step);
        if (!now && now.error().code == ErrorCode::cancelled) return fail(now.error());
        states[layer.id] = !now                         ? EvidenceState::missing
                           : *now == layer.data->sha256 ? EvidenceState::unchanged
                                                        : EvidenceState::changed;
    }
    return states;
}

}  // namespace

Evidence::Evidence(Document& document, JobRunner& jobs, Notices& notices, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), notices_(notices) {
    connect(&document_, &Document::replaced, this, [this] { verified_.clear(); });
}

EvidenceState Evidence::stateOf(const std::string& layer) const {
    const auto found = verified_.find(layer);
    if (found != verified_.end()) return found->second;
    const Layer* known = document_.state().layer(layer);
    return known && known->data ? EvidenceState::hashed : EvidenceState::notRead;
}

void Evidence::verify() {
    jobs_.run<States>(
        tr("Verifying evidence"),
        [scene = document_.state()](const JobControl& control) { return compare(scene, control); },
        [this](Result<States> states) {
            if (!states) return notices_.failed(states.error());
            verified_ = std::move(*states);
            int different = 0;
            for (const auto& [id, state] : verified_) different += state != EvidenceState::unchanged;
            notices_.inform(different == 0 ? tr("Every file is the one that was read (SHA-256).")
                                           : tr("%1 of the files differ from what was read.").arg(different));
            emit changed();
        });
}

}  // namespace vestige
