#include "core/scene/SavedViewEdits.h"

#include <algorithm>

#include "core/scene/edits/Same.h"

namespace vestige {
namespace {

using Views = std::vector<SavedView>;

bool same(const SavedView& a, const SavedView& b) {
    return a.name == b.name && same(a.camera, b.camera) && a.section == b.section &&
           a.colorMode == b.colorMode && a.scale == b.scale && a.inReport == b.inReport;
}

Views::iterator placeOf(Views& views, std::string_view name) {
    return std::find_if(views.begin(), views.end(), [&](const SavedView& view) { return view.name == name; });
}

/// The view at a place of the list is there or not: both are exchanged.
class SetSavedView final : public SceneEdit {
  public:
    SetSavedView(std::string name, std::optional<SavedView> view)
        : name_(std::move(name)), view_(std::move(view)) {}

    bool apply(SceneState& scene) override {
        if (name_.empty()) return false;
        const auto held = placeOf(scene.savedViews, name_);
        const bool known = held != scene.savedViews.end();
        if (!known && !view_) return false;
        if (known && view_ && same(*held, *view_)) return false;
        text_ = (!view_  ? "remove the view '"
                 : known ? "change the view '"
                         : "save the view '") +
                name_ + "'";
        place_ = held - scene.savedViews.begin();
        revert(scene);
        return true;
    }
    void revert(SceneState& scene) override {
        const auto held = placeOf(scene.savedViews, name_);
        std::optional<SavedView> before;
        if (held != scene.savedViews.end()) {
            before = std::move(*held);
            if (view_)
                *held = std::move(*view_);
            else
                scene.savedViews.erase(held);
        } else if (view_) {
            scene.savedViews.insert(scene.savedViews.begin() + place_, std::move(*view_));
        }
        view_ = std::move(before);
    }
    std::string describe() const override { return text_; }

  private:
    std::string name_;
    std::optional<SavedView> view_;
    std::ptrdiff_t place_ = 0;
    std::string text_;
};

class RenameSavedView final : public SceneEdit {
  public:
    RenameSavedView(std::string name, std::string newName)
        : name_(std::move(name)), newName_(std::move(newName)) {}

    bool apply(SceneState& scene) override {
        if (newName_.empty() || !savedView(scene, name_) || savedView(scene, newName_)) return false;
        placeOf(scene.savedViews, name_)->name = newName_;
        return true;
    }
    void revert(SceneState& scene) override { placeOf(scene.savedViews, newName_)->name = name_; }
    std::string describe() const override { return "rename the view '" + name_ + "' to '" + newName_ + "'"; }

  private:
    std::string name_;
    std::string newName_;
};

}  // namespace

std::unique_ptr<SceneEdit> setSavedView(SavedView view) {
    std::string name = view.name;
    return std::make_unique<SetSavedView>(std::move(name), std::move(view));
}

std::unique_ptr<SceneEdit> removeSavedView(std::string name) {
    return std::make_unique<SetSavedView>(std::move(name), std::nullopt);
}

std::unique_ptr<SceneEdit> renameSavedView(std::string name, std::string newName) {
    return std::make_unique<RenameSavedView>(std::move(name), std::move(newName));
}

const SavedView* savedView(const SceneState& scene, std::string_view name) {
    const auto held = std::find_if(scene.savedViews.begin(), scene.savedViews.end(),
                                   [&](const SavedView& view) { return view.name == name; });
    return held == scene.savedViews.end() ? nullptr : &*held;
}

std::string unusedViewName(const SceneState& scene) {
    for (std::size_t number = 1;; ++number) {
        std::string name = "View " + std::to_string(number);
        if (!savedView(scene, name)) return name;
    }
}

}  // namespace vestige
