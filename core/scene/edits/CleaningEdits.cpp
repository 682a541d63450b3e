#include "core/scene/CleaningEdits.h"

#include <algorithm>

#include "core/scene/edits/SwapEdit.h"

namespace vestige {
namespace {

SceneObject* objectOf(SceneState& scene, const std::string& name) {
    const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                    [&](const SceneObject& object) { return object.name == name; });
    return found == scene.objects.end() ? nullptr : &*found;
}

class AddObject final : public SceneEdit {
  public:
    explicit AddObject(SceneObject object) : object_(std::move(object)), text_("add " + object_.name) {}

    bool apply(SceneState& scene) override {
        if (object_.name.empty() || !object_.points || object_.points->empty() ||
            objectOf(scene, object_.name))
            return false;
        scene.objects.push_back(object_);
        return true;
    }
    void revert(SceneState& scene) override { scene.objects.pop_back(); }
    std::string describe() const override { return text_; }

  private:
    SceneObject object_;
    std::string text_;
};

class RemoveObject final : public SceneEdit {
  public:
    explicit RemoveObject(std::string name) : name_(std::move(name)) {}

    bool apply(SceneState& scene) override {
        const SceneObject* found = objectOf(scene, name_);
        if (!found) return false;
        place_ = found - scene.objects.data();
        removed_ = *found;
        scene.objects.erase(scene.objects.begin() + place_);
        return true;
    }
    void revert(SceneState& scene) override {
        scene.objects.insert(scene.objects.begin() + place_, removed_);
    }
    std::string describe() const override { return "forget " + name_; }

  private:
    std::string name_;
    SceneObject removed_;
    std::ptrdiff_t place_ = 0;
};

class RenameObject final : public SceneEdit {
  public:
    RenameObject(std::string name, std::string newName)
        : name_(std::move(name)), newName_(std::move(newName)) {}

    bool apply(SceneState& scene) override {
        SceneObject* found = objectOf(scene, name_);
        if (!found || newName_.empty() || objectOf(scene, newName_)) return false;
        found->name = newName_;
        return true;
    }
    void revert(SceneState& scene) override { objectOf(scene, newName_)->name = name_; }
    std::string describe() const override { return "rename " + name_ + " to " + newName_; }

  private:
    std::string name_;
    std::string newName_;
};

}  // namespace

std::unique_ptr<SceneEdit> setCleaning(std::string layer, std::shared_ptr<const Cleaning> cleaning,
                                       std::string description) {
    using Held = std::shared_ptr<const Cleaning>;
    const auto find = [id = std::move(layer)](SceneState& scene) -> Held* {
        Layer* found = scene.layer(id);
        return found ? &found->cleaning : nullptr;
    };
    return std::make_unique<SwapEdit<Held>>(std::move(description), find, std::move(cleaning));
}

std::unique_ptr<SceneEdit> addObject(SceneObject object) {
    return std::make_unique<AddObject>(std::move(object));
}

std::unique_ptr<SceneEdit> removeObject(std::string name) {
    return std::make_unique<RemoveObject>(std::move(name));
}

std::unique_ptr<SceneEdit> renameObject(std::string name, std::string newName) {
    return std::make_unique<RenameObject>(std::move(name), std::move(newName));
}

std::unique_ptr<SceneEdit> setObjectKind(std::string name, std::string kind) {
    const auto& kinds = objectKinds();
    const bool known = std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    std::string text = "call " + name + " " + kind;
    const auto find = [name = std::move(name), known](SceneState& scene) -> std::string* {
        SceneObject* object = objectOf(scene, name);
        return object && known ? &object->kind : nullptr;
    };
    return std::make_unique<SwapEdit<std::string>>(std::move(text), find, std::move(kind));
}

std::unique_ptr<SceneEdit> setObjectVisible(std::string name, bool visible) {
    std::string text = (visible ? "show " : "hide ") + name;
    const auto find = [name = std::move(name)](SceneState& scene) -> bool* {
        SceneObject* object = objectOf(scene, name);
        return object ? &object->visible : nullptr;
    };
    return std::make_unique<SwapEdit<bool>>(std::move(text), find, visible);
}

}  // namespace vestige
