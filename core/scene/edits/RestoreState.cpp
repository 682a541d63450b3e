#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "core/scene/SameData.h"

namespace vestige {
namespace {

class RestoreState final : public SceneEdit {
  public:
    RestoreState(SceneState state, std::string description)
        : state_(std::move(state)), text_(std::move(description)) {}

    bool apply(SceneState& scene) override {
        if (caseText(scene) == caseText(state_)) return false;
        revert(scene);
        return true;
    }
    void revert(SceneState& scene) override {
        std::swap(scene, state_);
        std::swap(scene.file, state_.file);
        // What was read belongs to the file, not to the edit.
        for (Layer& layer : scene.layers)
            for (const Layer& other : state_.layers) {
                if (!readsTheSame(layer, other)) continue;
                if (!layer.data) layer.data = other.data;
                if (!layer.evidence) layer.evidence = other.evidence;
            }
    }
    std::string describe() const override { return text_; }

  private:
    SceneState state_;
    std::string text_;
};

}  // namespace

std::unique_ptr<SceneEdit> restoreState(SceneState state, std::string description) {
    return std::make_unique<RestoreState>(std::move(state), std::move(description));
}

}  // namespace vestige
