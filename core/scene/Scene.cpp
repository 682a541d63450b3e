#include "core/scene/Scene.h"

#include "core/scene/FileEvidence.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
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
    std::set<std::string>
        opened;                   ///< layers of the case as it was opened: loading them changes nothing of it
    std::set<std::string> noted;  ///< added layers whose file became known, outside of a step, since the save
    std::uint64_t notes = 0;

    std::uint64_t current() const { return done.empty() ? 0 : done.back().number; }
    /// What no step holds any more needs no replacement: it would keep a whole cloud in memory.
    void forgetExpired() {
        std::erase_if(newer, [](const auto& pair) { return pair.first.expired(); });
    }
    void note(Layer& layer) {
        if (!noteEvidence(layer) || opened.contains(layer.id)) return;
        noted.insert(layer.id);
        ++notes;
    }
    void push(std::unique_ptr<SceneEdit> edit) {
        undone.clear();
        forgetExpired();
        done.push_back({std::move(edit), nextNumber++});
    }
};

Scene::Scene() : Scene(SceneState{}) {}
Scene::Scene(SceneState state) : state_(std::move(state)), history_(std::make_unique<History>()) {
    for (const Layer& layer : state_.layers) history_->opened.insert(layer.id);
}
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

std::uint64_t Scene::notes() const {
    return history_->notes;
}

bool Scene::modified() const {
    return history_->current() != history_->saved || (history_->group && !history_->group->empty()) ||
           std::any_of(state_.layers.begin(), state_.layers.end(),
                       [this](const Layer& layer) { return history_->noted.contains(layer.id); });
}

void Scene::markSaved(std::filesystem::path file) {
    state_.file = std::move(file);
    history_->saved = history_->current();
    history_->noted.clear();
    if (changed_) changed_();
}

void Scene::attachData(std::string_view layer, std::shared_ptr<const LayerData> data) {
    Layer* found = state_.layer(layer);
    if (!found) return;
    found->data = std::move(data);
    history_->note(*found);
    if (changed_) changed_();
}

void Scene::replaceData(const std::shared_ptr<const LayerData>& before,
                        std::shared_ptr<const LayerData> now) {
    if (!before || before == now) return;
    const auto old = before;  // which may be a layer's own
    history_->newer[old] = now;
    for (Layer& layer : state_.layers) {
        if (layer.data != old) continue;
        layer.data = now;
        history_->note(layer);
    }
    if (changed_) changed_();
}

void Scene::takeNewerData() {
    history_->forgetExpired();
    if (history_->newer.empty()) return;
    for (Layer& layer : state_.layers) {
        if (!layer.data) continue;
        const auto found = history_->newer.find(layer.data);
        if (found == history_->newer.end()) continue;
        layer.data = found->second;
        history_->note(layer);
    }
}

}  // namespace vestige
