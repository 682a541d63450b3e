#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// Two pictures of the scene laid into each other, to judge how well its clouds fit. Not part of the case, so
/// no edits.
class Comparison : public QObject {
    Q_OBJECT

  public:
    enum class What {
        beforeAfter,  ///< registered layers at their first pose, and where they lie
        sourceTarget  ///< all but the target, and the target alone
    };

    explicit Comparison(QObject* parent = nullptr);

    bool active() const { return mode_.has_value(); }
    std::optional<CompareMode> mode() const { return mode_; }
    What what() const { return what_; }
    int blink_ms() const { return blink_ms_; }
    bool held() const { return held_; }
    /// What the view shows; only while active.
    ViewComparison shown() const;

    /// Nothing: the plain view.
    void setMode(std::optional<CompareMode> mode);
    void setWhat(What what);
    /// Share of the view's width, 0.02 to 0.98.
    void setDivider(double share);
    void setTile(int pixels);
    void setBlink(int milliseconds);
    /// Stops and resumes the blinking; each stop shows the other picture.
    void toggleHeld();
    /// One step more or less of what the mode has: divider, size of the tiles, speed.
    void step(int direction);

    static constexpr int kTiles[] = {24, 32, 48, 64, 96, 128, 192, 256};
    static constexpr int kBlinks_ms[] = {200, 300, 500, 700, 1000, 1500, 2500};

  signals:
    /// It began or ended, or other pictures are compared.
    void switched();
    /// The same pictures are laid into each other differently.
    void adjusted();

  private:
    void runTimer();

    std::optional<CompareMode> mode_;
    What what_ = What::beforeAfter;
    double divider_ = 0.5;
    int tile_px_ = 96;
    int blink_ms_ = 700;
    bool otherShown_ = false;
    bool held_ = false;
    QTimer timer_;
};

}  // namespace vestige
