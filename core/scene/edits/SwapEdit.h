#pragma once

#include <functional>
#include <string>
#include <utility>

#include "core/scene/Scene.h"

namespace vestige {

/// The edit that most are: one value of the scene is exchanged for another and back.
template <class T>
class SwapEdit final : public SceneEdit {
  public:
    /// `find` gives the place of the value, null when the scene does not have it.
    SwapEdit(std::string description, std::function<T*(SceneState&)> find, T value)
        : description_(std::move(description)), find_(std::move(find)), value_(std::move(value)) {}

    bool apply(SceneState& scene) override {
        T* held = find_(scene);
        if (!held || *held == value_) return false;
        std::swap(*held, value_);
        return true;
    }
    void revert(SceneState& scene) override { std::swap(*find_(scene), value_); }
    std::string describe() const override { return description_; }

  private:
    std::string description_;
    std::function<T*(SceneState&)> find_;
    T value_;
};

}  // namespace vestige
