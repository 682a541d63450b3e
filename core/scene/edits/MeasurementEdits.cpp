#include <algorithm>
#include <cmath>

#include "core/scene/Edits.h"
#include "core/scene/edits/SwapEdit.h"

namespace vestige {
namespace {

class AddMeasurement final : public SceneEdit {
  public:
    AddMeasurement(Measurement measurement, std::string description)
        : measurement_(std::move(measurement)), text_(std::move(description)) {}

    bool apply(SceneState& scene) override {
        if (measurement_.object.empty()) return false;
        Measurement* held = scene.measurement(measurement_.object);
        if (held && *held == measurement_) return false;
        replaced_ = held != nullptr;
        if (replaced_)
            std::swap(*held, measurement_);
        else
            scene.measurements.push_back(measurement_);
        return true;
    }
    void revert(SceneState& scene) override {
        if (replaced_)
            std::swap(*scene.measurement(measurement_.object), measurement_);
        else
            scene.measurements.pop_back();
    }
    std::string describe() const override { return text_; }

  private:
    Measurement measurement_;
    std::string text_;
    bool replaced_ = false;
};

class RemoveMeasurement final : public SceneEdit {
  public:
    explicit RemoveMeasurement(std::string object) : object_(std::move(object)) {}

    bool apply(SceneState& scene) override {
        const auto found = std::find_if(scene.measurements.begin(), scene.measurements.end(),
                                        [&](const Measurement& held) { return held.object == object_; });
        if (found == scene.measurements.end()) return false;
        place_ = found - scene.measurements.begin();
        removed_ = std::move(*found);
        scene.measurements.erase(found);
        return true;
    }
    void revert(SceneState& scene) override {
        scene.measurements.insert(scene.measurements.begin() + place_, std::move(removed_));
    }
    std::string describe() const override { return "remove " + object_; }

  private:
    std::string object_;
    Measurement removed_;
    std::ptrdiff_t place_ = 0;
};

class RenameMeasurement final : public SceneEdit {
  public:
    RenameMeasurement(std::string object, std::string newName)
        : from_(std::move(object)), to_(std::move(newName)) {}

    bool apply(SceneState& scene) override {
        Measurement* held = scene.measurement(from_);
        if (!held || to_.empty() || scene.measurement(to_)) return false;
        held->object = to_;
        return true;
    }
    void revert(SceneState& scene) override { scene.measurement(to_)->object = from_; }
    std::string describe() const override { return "rename " + from_; }

  private:
    std::string from_;
    std::string to_;
};

}  // namespace

std::unique_ptr<SceneEdit> setMeasurement(Measurement measurement, std::string description) {
    return std::make_unique<AddMeasurement>(std::move(measurement), std::move(description));
}

std::unique_ptr<SceneEdit> removeMeasurement(std::string object) {
    return std::make_unique<RemoveMeasurement>(std::move(object));
}

std::unique_ptr<SceneEdit> renameMeasurement(std::string object, std::string newName) {
    return std::make_unique<RenameMeasurement>(std::move(object), std::move(newName));
}

std::unique_ptr<SceneEdit> setTape(std::string object, std::optional<double> tape_m) {
    std::string text = "set the tape of " + object;
    const bool allowed = !tape_m || (std::isfinite(*tape_m) && *tape_m > 0);
    const auto find = [object = std::move(object), allowed](SceneState& scene) -> std::optional<double>* {
        Measurement* held = scene.measurement(object);
        return held && allowed ? &held->tape_m : nullptr;
    };
    return std::make_unique<SwapEdit<std::optional<double>>>(std::move(text), find, tape_m);
}

}  // namespace vestige
