#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/geometry/ViewCamera.h"
#include "core/scene/Layer.h"
#include "core/scene/Measurement.h"
#include "core/scene/SavedView.h"
#include "core/scene/SceneObject.h"

namespace vestige {

struct Site {
    double latitude_deg = 0;
    double longitude_deg = 0;
    double height_m = 0;

    friend bool operator==(const Site&, const Site&) = default;
};

/// The document's plain data. Only a SceneEdit changes it, on the main thread.
struct SceneState {
    std::string name;
    std::string operatorName;
    std::optional<Site> site;
    std::vector<Layer> layers;
    std::string target;  ///< layer id that the others are registered to
    ParameterSet preprocess;
    ParameterSet registration;
    std::vector<Measurement> measurements;
    std::vector<SceneObject> objects;         ///< what was separated in the clouds
    std::vector<SavedView> savedViews;        ///< the analyst's, in their order
    std::map<std::string, ViewCamera> views;  ///< cameras that recorded aims name
    std::map<std::string, std::string>
        viewFrames;  ///< view -> layer whose file frame and unit its camera is in; see PickFrame.h
    std::filesystem::path file;  ///< where it was opened from or saved to; empty when new

    SceneState();
    const Layer* layer(std::string_view id) const;
    Layer* layer(std::string_view id);
    const Measurement* measurement(std::string_view object) const;
    Measurement* measurement(std::string_view object);
    /// `path` of a layer or picks file, made absolute against the case's folder.
    std::filesystem::path resolve(const std::filesystem::path& path) const;
};

/// One change of the scene that can be taken back. It keeps what it changed, not copies of the scene.
class SceneEdit {
  public:
    virtual ~SceneEdit() = default;
    /// False when it changed nothing; it then does not enter the history.
    virtual bool apply(SceneState& scene) = 0;
    virtual void revert(SceneState& scene) = 0;
    /// For "Undo ...": "pick mirror, repeat 2".
    virtual std::string describe() const = 0;
};

/// The document with its undo history: every change from the first day goes through perform().
class Scene {
  public:
    Scene();
    explicit Scene(SceneState state);
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;
    ~Scene();

    const SceneState& state() const { return state_; }

    /// Applies and remembers the edit; false when nothing changed. Drops what had been undone.
    bool perform(std::unique_ptr<SceneEdit> edit);
    bool canUndo() const;
    bool canRedo() const;
    void undo();
    void redo();
    std::string undoText() const;
    std::string redoText() const;
    /// Several edits as one step of the history; nested calls join the outer one.
    void begin(std::string description);
    void end();

    /// Number of the step that the state is after; 0: before the first. Numbers are given once.
    std::uint64_t step() const;
    /// How often the file of an added layer became known outside of a step: the case is another one then, and
    /// modified, though the step is the same.
    std::uint64_t notes() const;
    bool modified() const;
    void markSaved(std::filesystem::path file);

    /// Puts what was read for a layer into the document. Loading changes nothing of the case (but that the
    /// file is noted where none was), so it is not in the history; layers that are gone are ignored.
    void attachData(std::string_view layer, std::shared_ptr<const LayerData> data);

    /// Puts `now` in the place of `before` (a preview), wherever the document holds it: in layers that are
    /// there and in those that undo and redo bring back. Not in the history either.
    void replaceData(const std::shared_ptr<const LayerData>& before, std::shared_ptr<const LayerData> now);

    /// Called after every change (perform, undo, redo, markSaved, attachData, replaceData).
    void onChange(std::function<void()> handler) { changed_ = std::move(handler); }

  private:
    struct History;
    void takeNewerData();
    SceneState state_;
    std::unique_ptr<History> history_;
    std::function<void()> changed_;
};

}  // namespace vestige
