#include "ui/document/Document.h"

#include "core/base/Translation.h"
#include "core/scene/CaseFile.h"
#include "core/scene/CloudKinds.h"
#include "ui/document/Wording.h"
#include "ui/watch/WatchedTime.h"

namespace vestige {
namespace {

/// An edit of the history, in which what the case calls its things stays as it is.
QString inWords(const std::string& edit, const SceneState& state) {
    std::set<std::string, std::less<>> names;
    for (const Layer& layer : state.layers) names.insert({layer.id, layer.name});
    for (const Measurement& measurement : state.measurements) names.insert(measurement.object);
    return toQt(Translator(language(), std::move(names))(edit));
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent) {
    watch();
}

void Document::watch() {
    scene_.onChange([this] {
        cloudsGivenUp_ = false;
        if (open_ == 0) update();
    });
}

void Document::update() {
    {
        const WatchedTime watched("measuring the scene");
        measure();
    }
    const WatchedTime watched("Document::changed");
    emit changed();
}

void Document::measure() {
    uncomputed_.clear();
    if (!cloudsElsewhere_) {
        measured_ = measureScene(scene_.state());
        return;
    }
    const CloudKindsLater later(cloudsGivenUp_);
    measured_ = measureScene(scene_.state());
    uncomputed_ = later.missing();
}

void Document::measureCloudsElsewhere() {
    cloudsElsewhere_ = true;
}

void Document::measureAgain() {
    if (open_ == 0) update();
}

void Document::giveUpClouds() {
    cloudsGivenUp_ = true;
    measureAgain();
}

bool Document::perform(std::unique_ptr<SceneEdit> edit) {
    return scene_.perform(std::move(edit));
}

void Document::begin(const QString& description) {
    ++open_;
    scene_.begin(description.toStdString());
}

void Document::end() {
    scene_.end();
    if (--open_ == 0) update();
}

void Document::undo() {
    scene_.undo();
}

void Document::redo() {
    scene_.redo();
}

void Document::travel(int steps) {
    if (steps == 0) return;
    ++open_;
    for (; steps < 0 && canUndo(); ++steps) scene_.undo();
    for (; steps > 0 && canRedo(); --steps) scene_.redo();
    if (--open_ == 0) update();
}

QString Document::undoText() const {
    return inWords(scene_.undoText(), state());
}

QString Document::redoText() const {
    return inWords(scene_.redoText(), state());
}

QString Document::title() const {
    if (!state().name.empty()) return QString::fromStdString(state().name);
    const auto& file = state().file;
    if (file.filename() == "case.json") return toQt(file.parent_path().stem());
    if (!file.empty()) return toQt(file.stem());
    return tr("Untitled case");
}

Status Document::save(const std::filesystem::path& file) {
    if (Status written = writeCase(file, state()); !written) return written;
    savedBefore_.reset();
    scene_.markSaved(file);
    return {};
}

void Document::markSaved(const std::filesystem::path& file, std::uint64_t step, std::uint64_t notes) {
    const bool asNow = step == scene_.step() && notes == scene_.notes();
    savedBefore_ = asNow ? std::nullopt : std::optional(std::pair(step, notes));
    scene_.markSaved(file);
}

bool Document::modified() const {
    if (savedBefore_) return savedBefore_ != std::pair(scene_.step(), scene_.notes());
    return scene_.modified();
}

void Document::attachData(const std::string& layer, std::shared_ptr<const LayerData> data) {
    scene_.attachData(layer, std::move(data));
}

void Document::replaceData(const std::shared_ptr<const LayerData>& before,
                           std::shared_ptr<const LayerData> now) {
    scene_.replaceData(before, std::move(now));
}

void Document::replace(SceneState state) {
    scene_ = Scene(std::move(state));
    savedBefore_.reset();
    cloudsGivenUp_ = false;
    watch();
    emit replaced();
    update();
}

}  // namespace vestige
