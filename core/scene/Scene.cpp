#include "core/scene/Scene.h"

#include "core/scene/FileEvidence.h"

#include <map>
#include <memory>
#include <utility>

namespace vestige {
namespace {

/// Several edits that are undone as one.
class EditGroup final : public SceneEdit {
  public:
    explicit EditGroup(std::string description) : description_(std::move(description)) {}

    void add(std::unique_ptr<SceneEdit> edit) { edits_.push_back(std::move(edit)); }
    bool empty() const { return edits_.empty(); }

    bool apply(SceneState& scene) override {
        bool changed = false;
        for (auto& edit : edits_) changed = edit->apply(scene) || changed;
        return changed;
    }
    void revert(SceneState& scene) override {
        for (auto edit = edits_.rbegin(); edit != edits_.rend(); ++edit) (*edit)->revert(scene);
    }
    std::string describe() const override { return description_; }

  private:
    std::string description_;
    std::vector<std::unique_ptr<SceneEdit>> edits_;
};

/// Numbers are given once, so a state that was saved and then overwritten by another step is never mistaken
/// for the saved one.
struct Step {
    std::unique_ptr<SceneEdit> edit;
    std::uint64_t number = 0;
};

}  // namespace

struct Scene::History {
    std::vector<Step> done;
    std::vector<Step> undone;
    std::uint64_t nextNumber = 1;
    std::uint64_t saved = 0;  ///< number of the last step when saved; 0: before the first
    std::unique_ptr<EditGroup> group;
    int depth = 0;
    /// What replaced data that steps may still hold.
    std::map<std::weak_ptr<const LayerData>, std::shared_ptr<const LayerData>, std::owner_less<>> newer;

    std::uint64_t current() const { return done.empty() ? 0 : done.back().number; }
    void push(std::unique_ptr<SceneEdit> edit) {
        undone.clear();
        done.push_back({std::move(edit), nextNumber++});
    }
};

Scene::Scene() : Scene(SceneState{}) {}
Scene::Scene(SceneState state) : state_(std::move(state)), history_(std::make_unique<History>()) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

bool Scene::perform(std::unique_ptr<SceneEdit> edit) {
    if (!edit || !edit->apply(state_)) return false;
    takeNewerData();
    if (history_->group)
        history_->group->add(std::move(edit));
    else
        history_->push(std::move(edit));
    if (changed_) changed_();
    return true;
}

bool Scene::canUndo() const {
    return !history_->group && !history_->done.empty();
}

bool Scene::canRedo() const {
    return !history_->group && !history_->undone.empty();
}

void Scene::undo() {
    if (!canUndo()) return;
    Step step = std::move(history_->done.back());
    history_->done.pop_back();
    step.edit->revert(state_);
    takeNewerData();
    history_->undone.push_back(std::move(step));
    if (changed_) changed_();
}

void Scene::redo() {
    if (!canRedo()) return;
    Step step = std::move(history_->undone.back());
    history_->undone.pop_back();
    step.edit->apply(state_);
    takeNewerData();
    history_->done.push_back(std::move(step));
    if (changed_) changed_();
}

std::string Scene::undoText() const {
    return canUndo() ? history_->done.back().edit->describe() : std::string();
}

std::string Scene::redoText() const {
    return canRedo() ? history_->undone.back().edit->describe() : std::string();
}

void Scene::begin(std::string description) {
    if (history_->depth++ == 0) history_->group = std::make_unique<EditGroup>(std::move(description));
}

void Scene::end() {
    if (history_->depth == 0 || --history_->depth > 0) return;
    const std::unique_ptr<EditGroup> group = std::exchange(history_->group, nullptr);
    if (group->empty()) return;
    history_->push(std::make_unique<EditGroup>(std::move(*group)));
    if (changed_) changed_();
}

std::uint64_t Scene::step() const {
    return history_->current();
}

bool Scene::modified() const {
    return history_->current() != history_->saved || (history_->group && !history_->group->empty());
}

void Scene::markSaved(std::filesystem::path file) {
    state_.file = std::move(file);
    history_->saved = history_->current();
    if (changed_) changed_();
}

void Scene::attachData(std::string_view layer, std::shared_ptr<const LayerData> data) {
    Layer* found = state_.layer(layer);
    if (!found) return;
    found->data = std::move(data);
    noteEvidence(*found);
    if (changed_) changed_();
}

void Scene::replaceData(const std::shared_ptr<const LayerData>& before,
                        std::shared_ptr<const LayerData> now) {
    if (!before || before == now) return;
    history_->newer[before] = std::move(now);
    takeNewerData();
    if (changed_) changed_();
}

void Scene::takeNewerData() {
    if (history_->newer.empty()) return;
    for (Layer& layer : state_.layers) {
        if (!layer.data) continue;
        const auto found = history_->newer.find(layer.data);
        if (found == history_->newer.end()) continue;
        layer.data = found->second;
        noteEvidence(layer);
    }
}

}  // namespace vestige
