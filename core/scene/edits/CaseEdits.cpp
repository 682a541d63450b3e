#include "core/scene/Edits.h"
#include "core/scene/edits/Same.h"

namespace vestige {
namespace {

class SetCaseDetails final : public SceneEdit {
  public:
    SetCaseDetails(std::string name, std::string operatorName, std::optional<Site> site)
        : name_(std::move(name)), operator_(std::move(operatorName)), site_(site) {}

    bool apply(SceneState& scene) override {
        if (scene.name == name_ && scene.operatorName == operator_ && scene.site == site_) return false;
        revert(scene);
        return true;
    }
    void revert(SceneState& scene) override {
        std::swap(scene.name, name_);
        std::swap(scene.operatorName, operator_);
        std::swap(scene.site, site_);
    }
    std::string describe() const override { return "change the case's details"; }

  private:
    std::string name_;
    std::string operator_;
    std::optional<Site> site_;
};

/// A view with the layer it is bound to; none when the scene does not have it.
struct BoundView {
    ViewCamera camera;
    std::string frame;
    friend bool operator==(const BoundView& a, const BoundView& b) {
        return same(a.camera, b.camera) && a.frame == b.frame;
    }
};

class SetView final : public SceneEdit {
  public:
    SetView(std::string name, std::optional<BoundView> view)
        : name_(std::move(name)), view_(std::move(view)) {}

    bool apply(SceneState& scene) override {
        if (name_.empty() || held(scene) == view_) return false;
        text_ = (view_ ? "keep the view '" : "remove the view '") + name_ + "'";
        revert(scene);
        return true;
    }
    void revert(SceneState& scene) override {
        std::optional<BoundView> before = held(scene);
        scene.views.erase(name_);
        scene.viewFrames.erase(name_);
        if (view_) scene.views.emplace(name_, view_->camera);
        if (view_ && !view_->frame.empty()) scene.viewFrames.emplace(name_, view_->frame);
        view_ = std::move(before);
    }
    std::string describe() const override { return text_; }

  private:
    std::optional<BoundView> held(const SceneState& scene) const {
        const auto view = scene.views.find(name_);
        if (view == scene.views.end()) return std::nullopt;
        const auto frame = scene.viewFrames.find(name_);
        return BoundView{view->second, frame == scene.viewFrames.end() ? std::string() : frame->second};
    }

    std::string name_;
    std::string text_;
    std::optional<BoundView> view_;
};

}  // namespace

std::unique_ptr<SceneEdit> setCaseDetails(std::string name, std::string operatorName,
                                          std::optional<Site> site) {
    return std::make_unique<SetCaseDetails>(std::move(name), std::move(operatorName), site);
}

std::unique_ptr<SceneEdit> setView(std::string name, ViewCamera camera) {
    return std::make_unique<SetView>(std::move(name), BoundView{camera, {}});
}

std::unique_ptr<SceneEdit> removeView(std::string name) {
    return std::make_unique<SetView>(std::move(name), std::nullopt);
}

}  // namespace vestige
