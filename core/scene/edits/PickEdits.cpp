#include "core/scene/Edits.h"

namespace vestige {
namespace {

class AddPick final : public SceneEdit {
  public:
    AddPick(std::string object, std::string layer, PickedPair pair)
        : object_(std::move(object)), layer_(std::move(layer)), pair_(std::move(pair)) {}

    bool apply(SceneState& scene) override {
        Measurement* held = scene.measurement(object_);
        if (!held) return false;
        const auto [pairs, isNew] = held->picks.try_emplace(layer_);
        newKey_ = isNew;
        pairs->second.push_back(pair_);
        repeat_ = pairs->second.size();
        return true;
    }
    void revert(SceneState& scene) override {
        auto& picks = scene.measurement(object_)->picks;
        if (newKey_)
            picks.erase(layer_);
        else
            picks.at(layer_).pop_back();
    }
    std::string describe() const override {
        return "pick " + object_ + ", repeat " + std::to_string(repeat_);
    }

  private:
    std::string object_;
    std::string layer_;
    PickedPair pair_;
    std::size_t repeat_ = 0;
    bool newKey_ = false;
};

class RemovePick final : public SceneEdit {
  public:
    RemovePick(std::string object, std::string layer, std::size_t repeat)
        : object_(std::move(object)), layer_(std::move(layer)), repeat_(repeat) {}

    bool apply(SceneState& scene) override {
        Measurement* held = scene.measurement(object_);
        if (!held) return false;
        const auto found = held->picks.find(layer_);
        if (found == held->picks.end() || repeat_ >= found->second.size()) return false;
        const auto place = found->second.begin() + static_cast<std::ptrdiff_t>(repeat_);
        removed_ = *place;
        found->second.erase(place);
        return true;
    }
    void revert(SceneState& scene) override {
        auto& pairs = scene.measurement(object_)->picks.at(layer_);
        pairs.insert(pairs.begin() + static_cast<std::ptrdiff_t>(repeat_), removed_);
    }
    std::string describe() const override {
        return "remove repeat " + std::to_string(repeat_ + 1) + " of " + object_;
    }

  private:
    std::string object_;
    std::string layer_;
    std::size_t repeat_;
    PickedPair removed_;
};

class MovePick final : public SceneEdit {
  public:
    MovePick(std::string object, std::string layer, std::size_t repeat, bool second, PickedPoint point)
        : object_(std::move(object)),
          layer_(std::move(layer)),
          repeat_(repeat),
          second_(second),
          other_(std::move(point)) {}

    bool apply(SceneState& scene) override {
        PickedPoint* end = find(scene);
        if (!end || *end == other_) return false;
        std::swap(*end, other_);
        return true;
    }
    void revert(SceneState& scene) override { std::swap(*find(scene), other_); }
    std::string describe() const override {
        return "move pick " + object_ + ", repeat " + std::to_string(repeat_ + 1);
    }

  private:
    PickedPoint* find(SceneState& scene) const {
        Measurement* held = scene.measurement(object_);
        if (!held) return nullptr;
        const auto found = held->picks.find(layer_);
        if (found == held->picks.end() || repeat_ >= found->second.size()) return nullptr;
        PickedPair& pair = found->second[repeat_];
        return second_ ? &pair.b : &pair.a;
    }

    std::string object_;
    std::string layer_;
    std::size_t repeat_;
    bool second_;
    PickedPoint other_;  ///< what is not in the scene: the new end, after apply() the old one
};

}  // namespace

std::unique_ptr<SceneEdit> addPick(std::string object, std::string layer, PickedPair pair) {
    return std::make_unique<AddPick>(std::move(object), std::move(layer), std::move(pair));
}

std::unique_ptr<SceneEdit> removePick(std::string object, std::string layer, std::size_t repeat) {
    return std::make_unique<RemovePick>(std::move(object), std::move(layer), repeat);
}

std::unique_ptr<SceneEdit> movePick(std::string object, std::string layer, std::size_t repeat, bool second,
                                    PickedPoint point) {
    return std::make_unique<MovePick>(std::move(object), std::move(layer), repeat, second, std::move(point));
}

}  // namespace vestige
