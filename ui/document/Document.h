#pragma once

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/KindRepeats.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The open case for the window: core's Scene with signals and the figures measured on it. GUI thread only.
class Document : public QObject {
    Q_OBJECT

  public:
    explicit Document(QObject* parent = nullptr);

    const SceneState& state() const { return scene_.state(); }
    /// Of the present state.
    const MeasuredScene& measured() const { return measured_; }
    /// Figures that are found from clouds are left to whoever follows uncomputed() from now on.
    void measureCloudsElsewhere();
    /// What has been left of the present state; what is measured says so.
    const std::vector<KindRepeats>& uncomputed() const { return uncomputed_; }
    /// What had been left is remembered now.
    void measureAgain();
    /// What has been left stays so until the next change of the case; what is measured says so.
    void giveUpClouds();
    bool cloudsGivenUp() const { return cloudsGivenUp_; }

    /// The only way to change the case. False when the edit changed nothing.
    bool perform(std::unique_ptr<SceneEdit> edit);
    /// Edits between these two are one step of the history; `changed` comes once, at the end.
    void begin(const QString& description);
    void end();
    bool canUndo() const { return scene_.canUndo(); }
    bool canRedo() const { return scene_.canRedo(); }
    void undo();
    void redo();
    /// Takes that many steps back (negative) or does them again, as far as there are any; `changed` comes
    /// once.
    void travel(int steps);
    /// In the language of the window.
    QString undoText() const;
    QString redoText() const;
    /// What undo would take back, and redo do again, as the history and the journal have it: in English.
    std::string lastEdit() const { return scene_.undoText(); }
    std::string nextEdit() const { return scene_.redoText(); }

    bool modified() const;
    /// The case's name, else the file's, else "Untitled case".
    QString title() const;
    /// Writes the case and notes `file` as its place.
    Status save(const std::filesystem::path& file);
    /// It was saved as it was after `step`, with `notes`; there may have been other edits meanwhile.
    void markSaved(const std::filesystem::path& file, std::uint64_t step, std::uint64_t notes);
    /// Of the history; see Scene.
    std::uint64_t step() const { return scene_.step(); }
    std::uint64_t notes() const { return scene_.notes(); }
    /// What was read for a layer, and what takes the place of a preview; see Scene.
    void attachData(const std::string& layer, std::shared_ptr<const LayerData> data);
    void replaceData(const std::shared_ptr<const LayerData>& before, std::shared_ptr<const LayerData> now);
    /// Another case, with an empty history.
    void replace(SceneState state);

  signals:
    /// After every edit, undo, redo, save and replacement.
    void changed();
    /// Another case was put in its place; comes before `changed`.
    void replaced();

  private:
    void watch();
    void update();
    void measure();

    Scene scene_;
    MeasuredScene measured_;
    std::vector<KindRepeats> uncomputed_;
    bool cloudsElsewhere_ = false;
    bool cloudsGivenUp_ = false;
    std::optional<std::pair<std::uint64_t, std::uint64_t>>
        savedBefore_;  ///< step and notes, not the last ones
    int open_ = 0;     ///< nested begin()
};

}  // namespace vestige
