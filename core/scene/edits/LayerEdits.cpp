#include <algorithm>

#include "core/scene/Cleaning.h"
#include "core/scene/Edits.h"
#include "core/scene/SameData.h"
#include "core/scene/casefile/CaseJson.h"
#include "core/scene/edits/MovePicks.h"
#include "core/scene/edits/SwapEdit.h"

namespace vestige {
namespace {

std::string quoted(const Layer& layer) {
    return "'" + (layer.name.empty() ? layer.id : layer.name) + "'";
}

class AddLayer final : public SceneEdit {
  public:
    explicit AddLayer(Layer layer) : layer_(std::move(layer)), text_("add layer " + quoted(layer_)) {}

    bool apply(SceneState& scene) override {
        if (layer_.id.empty() || scene.layer(layer_.id)) return false;
        madeTarget_ = scene.layers.empty() && scene.target.empty();
        if (madeTarget_) scene.target = layer_.id;
        scene.layers.push_back(std::move(layer_));
        return true;
    }
    void revert(SceneState& scene) override {
        layer_ = std::move(scene.layers.back());
        scene.layers.pop_back();
        if (madeTarget_) scene.target.clear();
    }
    std::string describe() const override { return text_; }

  private:
    Layer layer_;
    std::string text_;
    bool madeTarget_ = false;
};

class RemoveLayer final : public SceneEdit {
  public:
    explicit RemoveLayer(std::string id) : id_(std::move(id)) {}

    bool apply(SceneState& scene) override {
        const auto found = std::find_if(scene.layers.begin(), scene.layers.end(),
                                        [&](const Layer& layer) { return layer.id == id_; });
        if (found == scene.layers.end()) return false;
        place_ = found - scene.layers.begin();
        removed_ = std::move(*found);
        scene.layers.erase(found);
        wasTarget_ = scene.target == id_;
        if (wasTarget_) scene.target.clear();
        return true;
    }
    void revert(SceneState& scene) override {
        scene.layers.insert(scene.layers.begin() + place_, std::move(removed_));
        if (wasTarget_) scene.target = id_;
    }
    std::string describe() const override { return "remove layer '" + id_ + "'"; }

  private:
    std::string id_;
    Layer removed_;
    std::ptrdiff_t place_ = 0;
    bool wasTarget_ = false;
};

class ChangeLayer final : public SceneEdit {
  public:
    ChangeLayer(Layer layer, std::string description)
        : layer_(std::move(layer)), text_(std::move(description)) {}

    bool apply(SceneState& scene) override {
        Layer* held = scene.layer(layer_.id);
        if (!held) return false;
        const bool sameData = !layer_.data || layer_.data == held->data;
        if (sameData && sameText(*held, layer_)) return false;
        moved_ = changeKeepingPicks(scene, [this](SceneState& changing) { exchange(changing); });
        return true;
    }
    void revert(SceneState& scene) override {
        exchange(scene);
        restorePicks(scene, moved_);
    }
    std::string describe() const override { return text_; }

  private:
    void exchange(SceneState& scene) {
        Layer& held = *scene.layer(layer_.id);
        std::swap(held, layer_);
        // Data that was attached after this edit was made, or undone, belongs to the file, not to the edit.
        if (!readsTheSame(held, layer_)) return;
        // So does what a job made of them in the meantime; the history then holds them only as loaded.
        const bool sameLoaded = loadedData(held) && loadedData(held) == loadedData(layer_);
        if (!held.data || sameLoaded) held.data = layer_.data;
        if (sameLoaded) layer_.data = loadedData(layer_);
        if (!held.evidence) held.evidence = layer_.evidence;
    }

    Layer layer_;
    std::string text_;
    std::vector<MovedPick> moved_;
};

}  // namespace

std::unique_ptr<SceneEdit> addLayer(Layer layer) {
    return std::make_unique<AddLayer>(std::move(layer));
}

std::unique_ptr<SceneEdit> removeLayer(std::string id) {
    return std::make_unique<RemoveLayer>(std::move(id));
}

std::unique_ptr<SceneEdit> changeLayer(Layer layer, std::string description) {
    return std::make_unique<ChangeLayer>(std::move(layer), std::move(description));
}

std::unique_ptr<SceneEdit> setLayerVisible(std::string id, bool visible) {
    std::string text = (visible ? "show layer '" : "hide layer '") + id + "'";
    const auto find = [id = std::move(id)](SceneState& scene) -> bool* {
        Layer* layer = scene.layer(id);
        return layer ? &layer->visible : nullptr;
    };
    return std::make_unique<SwapEdit<bool>>(std::move(text), find, visible);
}

std::string unusedLayerId(const SceneState& scene, const std::string& wanted) {
    const std::string stem = wanted.empty() ? "layer" : wanted;
    std::string id = stem;
    for (int number = 2; scene.layer(id); ++number) id = stem + "-" + std::to_string(number);
    return id;
}

}  // namespace vestige
