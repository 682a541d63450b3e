#include "ui/document/Attempts.h"

#include "ui/document/Document.h"
#include "ui/document/Preview.h"
#include "ui/document/Selection.h"

namespace vestige {

Attempts::Attempts(const Document& document, Preview& preview, QObject* parent)
    : QObject(parent), document_(document), preview_(preview) {
    connect(&document_, &Document::changed, this, [this] { dropOutdated(); });
    connect(&document_, &Document::replaced, this, [this] {
        attempts_.clear();
        preview_.end();
        emit changed();
    });
    connect(&preview_, &Preview::changed, this, [this] {
        if (preview_.owner() == this || previewed_.empty()) return;
        previewed_.clear();
        emit changed();
    });
}

const RegistrationResult* Attempts::of(const std::string& layer) const {
    const auto found = attempts_.find(layer);
    return found == attempts_.end() ? nullptr : &found->second.result;
}

void Attempts::set(const std::string& layer, RegistrationResult result) {
    target_ = document_.state().target;
    attempts_[layer] = {std::move(result), 0};
    emit changed();
}

void Attempts::forget(const std::string& layer) {
    if (attempts_.erase(layer) == 0) return;
    if (previewed_ == layer) preview_.end();
    emit changed();
}

std::size_t Attempts::chosen(const std::string& layer) const {
    const auto found = attempts_.find(layer);
    return found == attempts_.end() ? 0 : found->second.chosen;
}

void Attempts::choose(const std::string& layer, std::size_t candidate) {
    const auto found = attempts_.find(layer);
    if (found == attempts_.end() || candidate >= found->second.result.candidates.size()) return;
    found->second.chosen = candidate;
    showPreview(layer, true);
}

Similarity Attempts::pose(const std::string& layer) const {
    const RegistrationResult* result = of(layer);
    if (!result) return {};
    if (result->candidates.empty()) return result->targetFromSource;
    return result->candidates[chosen(layer)].targetFromSource;
}

void Attempts::showPreview(const std::string& layer, bool show) {
    const RegistrationResult* result = of(layer);
    if (!show || !result) {
        if (previewed_ == layer) preview_.end();
        return;
    }
    const QString words = result->candidates.empty()
                              ? tr("Preview of a pose that was refused; the layer was not moved")
                              : tr("Preview of candidate %1 of %2; the layer was not moved")
                                    .arg(chosen(layer) + 1)
                                    .arg(result->candidates.size());
    previewed_ = layer;
    preview_.show(this, layer, pose(layer), words);
    emit changed();
}

bool Attempts::previewed(const std::string& layer) const {
    return !layer.empty() && previewed_ == layer;
}

/// What was found for a layer that has moved since, has gone, or was laid on another target.
void Attempts::dropOutdated() {
    const SceneState& scene = document_.state();
    const auto outdated = [&](const auto& entry) {
        return scene.target != target_ || !scene.layer(entry.first);
    };
    if (std::erase_if(attempts_, outdated) == 0) return;
    if (!previewed_.empty() && !of(previewed_)) preview_.end();
    emit changed();
}

ShownFit shownFit(const Document& document, const Selection& selection, const Attempts& attempts) {
    const auto fitOf = [&](const Layer& layer) -> ShownFit {
        if (const RegistrationResult* refused = attempts.of(layer.id)) return {&layer, refused, false};
        if (layer.registration) return {&layer, &*layer.registration, true};
        return {};
    };
    const SceneState& scene = document.state();
    if (const Layer* selected = scene.layer(selection.layer()))
        if (const ShownFit fit = fitOf(*selected); fit.layer) return fit;
    for (auto it = scene.layers.rbegin(); it != scene.layers.rend(); ++it)
        if (const ShownFit fit = fitOf(*it); fit.layer) return fit;
    return {};
}

}  // namespace vestige
