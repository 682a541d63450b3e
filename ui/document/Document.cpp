#include "ui/document/Document.h"

#include "core/scene/CaseFile.h"
#include "ui/document/Wording.h"

namespace vestige {

Document::Document(QObject* parent) : QObject(parent) {
    watch();
}

void Document::watch() {
    scene_.onChange([this] {
        if (open_ == 0) update();
    });
}

void Document::update() {
    measured_ = measureScene(scene_.state());
    emit changed();
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
    return said(scene_.undoText());
}

QString Document::redoText() const {
    return said(scene_.redoText());
}

QString Document::title() const {
    if (!state().name.empty()) return QString::fromStdString(state().name);
    const auto& file = state().file;
    if (file.filename() == "case.json") return toQt(file.parent_path().stem());
    if (!file.empty()) return toQt(file.stem());
    return tr("Untitled case");
}

Status Document::save(const std::filesystem::path& file) {
    return saveWith(file, [&](const SceneState& scene) { return writeCase(file, scene); });
}

Status Document::saveWith(const std::filesystem::path& file,
                          const std::function<Status(const SceneState&)>& write) {
    if (Status written = write(state()); !written) return written;
    scene_.markSaved(file);
    return {};
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
    watch();
    emit replaced();
    update();
}

}  // namespace vestige
