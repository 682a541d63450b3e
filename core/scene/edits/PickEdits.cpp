#include "core/scene/Edits.h"
#include "core/scene/edits/SwapEdit.h"

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

}  // namespace

std::unique_ptr<SceneEdit> addPick(std::string object, std::string layer, PickedPair pair) {
    return std::make_unique<AddPick>(std::move(object), std::move(layer), std::move(pair));
}

std::unique_ptr<SceneEdit> removePick(std::string object, std::string layer, std::size_t repeat) {
    return std::make_unique<RemovePick>(std::move(object), std::move(layer), repeat);
}

std::unique_ptr<SceneEdit> movePick(std::string object, std::string layer, std::size_t repeat, bool second,
                                    PickedPoint point) {
    std::string description = "move pick " + object + ", repeat " + std::to_string(repeat + 1);
    const auto find = [object = std::move(object), layer = std::move(layer), repeat,
                       second](SceneState& scene) -> PickedPoint* {
        Measurement* held = scene.measurement(object);
        if (!held) return nullptr;
        const auto found = held->picks.find(layer);
        if (found == held->picks.end() || repeat >= found->second.size()) return nullptr;
        PickedPair& pair = found->second[repeat];
        return second ? &pair.b : &pair.a;
    };
    return std::make_unique<SwapEdit<PickedPoint>>(std::move(description), find, std::move(point));
}

}  // namespace vestige
