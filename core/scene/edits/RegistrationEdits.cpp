#include "core/scene/Edits.h"
#include "core/scene/casefile/CaseJson.h"
#include "core/scene/edits/MovePicks.h"

namespace vestige {
namespace {

using OptionalResult = std::optional<RegistrationResult>;

bool same(const OptionalResult& a, const OptionalResult& b) {
    return a.has_value() == b.has_value() && (!a || sameText(*a, *b));
}

class SetRegistration final : public SceneEdit {
  public:
    SetRegistration(std::string layer, OptionalResult result)
        : id_(std::move(layer)),
          text_((result ? "register layer '" : "undo the registration of layer '") + id_ + "'"),
          result_(std::move(result)) {}

    bool apply(SceneState& scene) override {
        const Layer* layer = scene.layer(id_);
        if (!layer || same(layer->registration, result_)) return false;
        moved_ = changeKeepingPicks(scene, [this](SceneState& changing) { exchange(changing); });
        return true;
    }
    void revert(SceneState& scene) override {
        exchange(scene);
        restorePicks(scene, moved_);
    }
    std::string describe() const override { return text_; }

  private:
    void exchange(SceneState& scene) { std::swap(scene.layer(id_)->registration, result_); }

    std::string id_;
    std::string text_;
    OptionalResult result_;
    std::vector<MovedPick> moved_;
};

class SetTarget final : public SceneEdit {
  public:
    explicit SetTarget(std::string layer)
        : target_(std::move(layer)), text_("register to layer '" + target_ + "'") {}

    bool apply(SceneState& scene) override {
        if (!scene.layer(target_) || scene.target == target_) return false;
        moved_ = changeKeepingPicks(scene, [this](SceneState& changing) {
            std::swap(changing.target, target_);
            dropped_.clear();
            for (Layer& layer : changing.layers)
                dropped_.push_back(std::exchange(layer.registration, std::nullopt));
        });
        return true;
    }
    void revert(SceneState& scene) override {
        std::swap(scene.target, target_);
        for (std::size_t i = 0; i < dropped_.size(); ++i)
            scene.layers[i].registration = std::move(dropped_[i]);
        restorePicks(scene, moved_);
    }
    std::string describe() const override { return text_; }

  private:
    std::string target_;
    std::string text_;
    std::vector<OptionalResult> dropped_;
    std::vector<MovedPick> moved_;
};

}  // namespace

std::unique_ptr<SceneEdit> setRegistration(std::string layer, std::optional<RegistrationResult> result) {
    return std::make_unique<SetRegistration>(std::move(layer), std::move(result));
}

std::unique_ptr<SceneEdit> setTarget(std::string layer) {
    return std::make_unique<SetTarget>(std::move(layer));
}

}  // namespace vestige
