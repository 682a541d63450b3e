#include "core/scene/KindEdits.h"

#include <cmath>

#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/edits/SwapEdit.h"

namespace vestige {
namespace {

class SetKind final : public SceneEdit {
  public:
    SetKind(std::string object, MeasurementKind kind) : object_(std::move(object)), kind_(kind) {}

    bool apply(SceneState& scene) override {
        Measurement* held = scene.measurement(object_);
        if (!held || held->kind == kind_) return false;
        settings_ = held->settings;
        const ParameterSet known(*kindSpec(kind_).parameters);
        std::erase_if(settings_, [&](const auto& setting) {
            return !known.find(setting.first) || !kindSettings(kind_, {setting});
        });
        revert(scene);
        return true;
    }
    void revert(SceneState& scene) override {
        Measurement* held = scene.measurement(object_);
        std::swap(held->kind, kind_);
        std::swap(held->settings, settings_);
    }
    std::string describe() const override { return "set the kind of " + object_; }

  private:
    std::string object_;
    MeasurementKind kind_;
    std::map<std::string, double> settings_;
};

class SetSetting final : public SceneEdit {
  public:
    SetSetting(std::string object, std::string key, std::optional<double> value)
        : object_(std::move(object)), key_(std::move(key)), value_(value) {}

    bool apply(SceneState& scene) override {
        Measurement* held = scene.measurement(object_);
        if (!held || (value_ && !kindSettings(held->kind, {{key_, *value_}}))) return false;
        const auto found = held->settings.find(key_);
        before_ = found == held->settings.end() ? std::nullopt : std::optional(found->second);
        if (before_ == value_) return false;
        put(*held, value_);
        return true;
    }
    void revert(SceneState& scene) override { put(*scene.measurement(object_), before_); }
    std::string describe() const override { return "set " + key_ + " of " + object_; }

  private:
    void put(Measurement& measurement, const std::optional<double>& value) const {
        if (value)
            measurement.settings[key_] = *value;
        else
            measurement.settings.erase(key_);
    }

    std::string object_;
    std::string key_;
    std::optional<double> value_, before_;
};

class AddPath final : public SceneEdit {
  public:
    AddPath(std::string object, std::string layer, PickedPath path)
        : object_(std::move(object)), layer_(std::move(layer)), path_(std::move(path)) {}

    bool apply(SceneState& scene) override {
        Measurement* held = scene.measurement(object_);
        if (!held || path_.empty() || path_.size() > kMostPathPoints) return false;
        std::size_t points = path_.size();
        for (const auto& [key, paths] : held->paths)
            for (const PickedPath& path : paths) points += path.size();
        if (points > kMostPointsOfAnObject) return false;
        const auto [paths, isNew] = held->paths.try_emplace(layer_);
        newKey_ = isNew;
        paths->second.push_back(path_);
        repeat_ = paths->second.size();
        return true;
    }
    void revert(SceneState& scene) override {
        auto& paths = scene.measurement(object_)->paths;
        if (newKey_)
            paths.erase(layer_);
        else
            paths.at(layer_).pop_back();
    }
    std::string describe() const override {
        return "pick " + object_ + ", repeat " + std::to_string(repeat_);
    }

  private:
    std::string object_;
    std::string layer_;
    PickedPath path_;
    std::size_t repeat_ = 0;
    bool newKey_ = false;
};

class RemovePath final : public SceneEdit {
  public:
    RemovePath(std::string object, std::string layer, std::size_t repeat)
        : object_(std::move(object)), layer_(std::move(layer)), repeat_(repeat) {}

    bool apply(SceneState& scene) override {
        Measurement* held = scene.measurement(object_);
        if (!held) return false;
        const auto found = held->paths.find(layer_);
        if (found == held->paths.end() || repeat_ >= found->second.size()) return false;
        const auto place = found->second.begin() + static_cast<std::ptrdiff_t>(repeat_);
        removed_ = std::move(*place);
        found->second.erase(place);
        return true;
    }
    void revert(SceneState& scene) override {
        auto& paths = scene.measurement(object_)->paths.at(layer_);
        paths.insert(paths.begin() + static_cast<std::ptrdiff_t>(repeat_), std::move(removed_));
    }
    std::string describe() const override {
        return "remove repeat " + std::to_string(repeat_ + 1) + " of " + object_;
    }

  private:
    std::string object_;
    std::string layer_;
    std::size_t repeat_;
    PickedPath removed_;
};

}  // namespace

std::unique_ptr<SceneEdit> setKind(std::string object, MeasurementKind kind) {
    return std::make_unique<SetKind>(std::move(object), kind);
}

std::unique_ptr<SceneEdit> setKindSetting(std::string object, std::string key, std::optional<double> value) {
    return std::make_unique<SetSetting>(std::move(object), std::move(key), value);
}

std::unique_ptr<SceneEdit> addPath(std::string object, std::string layer, PickedPath path) {
    return std::make_unique<AddPath>(std::move(object), std::move(layer), std::move(path));
}

std::unique_ptr<SceneEdit> removePath(std::string object, std::string layer, std::size_t repeat) {
    return std::make_unique<RemovePath>(std::move(object), std::move(layer), repeat);
}

std::unique_ptr<SceneEdit> setCheck(std::string object, std::optional<double> tolerance_m) {
    std::string text = (tolerance_m ? "check the survey by " : "no longer check the survey by ") + object;
    const bool allowed = !tolerance_m || (std::isfinite(*tolerance_m) && *tolerance_m > 0);
    const auto find = [object = std::move(object), allowed](SceneState& scene) -> std::optional<double>* {
        Measurement* held = scene.measurement(object);
        return held && allowed ? &held->checkTolerance_m : nullptr;
    };
    return std::make_unique<SwapEdit<std::optional<double>>>(std::move(text), find, tolerance_m);
}

}  // namespace vestige
