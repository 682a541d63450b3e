#include "core/scene/KindEdits.h"

namespace vestige {
namespace {

class MovePathPoint final : public SceneEdit {
  public:
    MovePathPoint(std::string object, std::string layer, std::size_t repeat, std::size_t place,
                  PickedPoint point)
        : object_(std::move(object)),
          layer_(std::move(layer)),
          repeat_(repeat),
          place_(place),
          other_(std::move(point)) {}

    bool apply(SceneState& scene) override {
        PickedPoint* point = find(scene);
        if (!point || *point == other_) return false;
        std::swap(*point, other_);
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
        const auto found = held->paths.find(layer_);
        if (found == held->paths.end() || repeat_ >= found->second.size()) return nullptr;
        PickedPath& path = found->second[repeat_];
        return place_ < path.size() ? &path[place_] : nullptr;
    }

    std::string object_;
    std::string layer_;
    std::size_t repeat_;
    std::size_t place_;
    PickedPoint other_;  ///< what is not in the scene: the new point, after apply() the old one
};

}  // namespace

std::unique_ptr<SceneEdit> movePathPoint(std::string object, std::string layer, std::size_t repeat,
                                         std::size_t place, PickedPoint point) {
    return std::make_unique<MovePathPoint>(std::move(object), std::move(layer), repeat, place,
                                           std::move(point));
}

}  // namespace vestige
