#include "core/scene/Edits.h"

namespace vestige {
namespace {

/// Exchanges one value of a parameter set; a value that the parameter does not allow changes nothing.
class SetParameter final : public SceneEdit {
  public:
    SetParameter(ParameterSet SceneState::*set, std::string key, ParameterValue value)
        : set_(set), key_(std::move(key)), value_(std::move(value)), text_("set " + key_) {}

    bool apply(SceneState& scene) override {
        ParameterSet& set = scene.*set_;
        const ParameterSpec* spec = set.find(key_);
        if (!spec) return false;
        ParameterValue before = set.value(key_);
        if (!set.set(key_, value_) || set.value(key_) == before) return false;
        text_ = "set " + spec->label + " to " + set.display(key_);
        value_ = std::move(before);
        return true;
    }
    void revert(SceneState& scene) override {
        ParameterValue applied = (scene.*set_).value(key_);
        // Was held by this very set, so it is allowed.
        (void)(scene.*set_).set(key_, value_);
        value_ = std::move(applied);
    }
    std::string describe() const override { return text_; }

  private:
    ParameterSet SceneState::*set_;
    std::string key_;
    ParameterValue value_;
    std::string text_;
};

}  // namespace

std::unique_ptr<SceneEdit> setPreprocessParameter(std::string key, ParameterValue value) {
    return std::make_unique<SetParameter>(&SceneState::preprocess, std::move(key), std::move(value));
}

std::unique_ptr<SceneEdit> setRegistrationParameter(std::string key, ParameterValue value) {
    return std::make_unique<SetParameter>(&SceneState::registration, std::move(key), std::move(value));
}

}  // namespace vestige
