#include "ui/document/Evidence.h"

#include <algorithm>
#include <iterator>

#include "core/io/InputHash.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

using States = std::map<std::string, EvidenceState>;

Result<States> compare(const SceneState& scene, const JobControl& control) {
    States states;
    for (std::size_t i = 0; i < scene.layers.size(); ++i) {
        const Layer& layer = scene.layers[i];
        if (!layer.data || layer.data->isPreview()) continue;
        const double count = static_cast<double>(scene.layers.size());
        const auto step = control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        step.progress(0, "Hashing " + layer.path.filename().string());
        const auto now = hashInput(scene.resolve(layer.path), layer.data->info.companions, step);
        if (!now && now.error().code == ErrorCode::cancelled) return fail(now.error());
        const std::string& expected = layer.evidence ? layer.evidence->sha256 : layer.data->sha256;
        states[layer.id] = !now                      ? EvidenceState::missing
                           : now->sha256 == expected ? EvidenceState::unchanged
                                                     : EvidenceState::changed;
    }
    return states;
}

}  // namespace

Evidence::Evidence(Document& document, JobRunner& jobs, Notices& notices, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), notices_(notices) {
    connect(&document_, &Document::replaced, this, [this] {
        verified_.clear();
        known_.clear();
    });
    connect(&document_, &Document::changed, this, [this] {
        forgetOldData();
        watchFiles();
    });
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this,
            [this](const QString& p) { onFileChanged(p); });
}

EvidenceState Evidence::stateOf(const std::string& layer) const {
    const auto found = verified_.find(layer);
    if (found != verified_.end()) return found->second;
    const Layer* known = document_.state().layer(layer);
    if (!known || !known->data || known->data->isPreview()) return EvidenceState::notRead;
    return evidenceDifference(*known) ? EvidenceState::changed : EvidenceState::hashed;
}

/// What was found out of a file that has been read again since says nothing of what was read then.
void Evidence::forgetOldData() {
    bool forgot = false;
    for (const Layer& layer : document_.state().layers) {
        if (!layer.data) continue;
        // Cleaning makes other data of the same reading.
        const auto read = layer.data->uncleaned ? layer.data->uncleaned : layer.data;
        auto& known = known_[layer.id];
        if (known.lock() == read) continue;
        known = read;
        forgot = verified_.erase(layer.id) > 0 || forgot;
    }
    if (forgot) emit changed();
}

void Evidence::watchFiles() {
    QStringList wanted;
    for (const Layer& layer : document_.state().layers)
        if (layer.data) wanted << toQt(document_.state().resolve(layer.path));
    const QStringList watched = watcher_.files();
    QStringList gone, fresh;
    std::copy_if(watched.begin(), watched.end(), std::back_inserter(gone),
                 [&](const QString& path) { return !wanted.contains(path); });
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(fresh),
                 [&](const QString& path) { return !watched.contains(path); });
    if (!gone.isEmpty()) watcher_.removePaths(gone);
    if (!fresh.isEmpty()) watcher_.addPaths(fresh);
}

void Evidence::onFileChanged(const QString& path) {
    for (const Layer& layer : document_.state().layers) {
        const auto file = document_.state().resolve(layer.path);
        if (!layer.data || toQt(file) != path) continue;
        const auto now = stampOf(file);
        if (now && *now == layer.data->stamp) continue;
        const EvidenceState state = now ? EvidenceState::touched : EvidenceState::missing;
        if (const auto known = verified_.find(layer.id); known != verified_.end() && known->second == state)
            continue;
        verified_[layer.id] = state;
        notices_.warn(
            (now ? tr("%1 was changed by another program after it was read (layer '%2'). The case still "
                      "shows what was read; Verify evidence tells whether the content differs.")
                 : tr("%1 is gone since it was read (layer '%2'). The case still shows what was read."))
                .arg(path, QString::fromStdString(layer.id)));
        emit changed();
    }
    // A file that was replaced has to be watched anew.
    watchFiles();
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
