#pragma once

#include <QCursor>
#include <QObject>
#include <QPoint>
#include <QSize>
#include <QTimer>
#include <optional>

#include "ui/tools/PickHandles.h"
#include "ui/tools/ProbedPlace.h"

class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace vestige {

class Document;
class PickFeedback;
class PickProbe;
class SceneView;

/// Moves points that were picked, ends of pairs and corners of paths: by dragging their handles, or pixel by
/// pixel with the arrow keys. Each move is picked and snapped anew while it lasts, enters the case as one
/// step when it ends, and leaves it as it was on Esc. Only a press on a handle begins one, so that turning
/// the view moves nothing.
class PickMover : public QObject {
    Q_OBJECT

  public:
    PickMover(Document& document, Selection& selection, PickProbe& probe, PickFeedback& feedback,
              QObject* parent = nullptr);

    /// The cursor moves with no button down: the handle under it stands out. True when there is one.
    bool point(SceneView& view, const QPoint& position);
    /// True when the press is on a handle; the events up to the release are then for this object.
    bool press(SceneView& view, const QMouseEvent& event);
    bool move(SceneView& view, const QMouseEvent& event);
    /// True when it ends a drag; false for a click on a handle, which makes it the one that keys move.
    bool release(SceneView& view, const QMouseEvent& event);
    /// Esc gives up a move, the arrow keys nudge.
    bool keyPress(SceneView& view, const QKeyEvent& event);
    bool holdsKey(const QKeyEvent& event) const;

    /// A press on a handle waits for its release.
    bool holding() const { return held_.has_value(); }
    /// A move has begun that has not entered the case.
    bool moving() const { return (held_ && held_->dragging) || nudge_; }

    /// The point that the arrow keys move.
    void select(std::optional<PickHandle> handle);
    /// The tool is left: what was nudged enters the case, a drag is given up.
    void leave(SceneView& view);
    /// Repeats of the selected object; with their handles, when these can be taken hold of.
    void paint(QPainter& painter, const ViewCamera& camera, const ViewTheme& theme, bool handles) const;

  signals:
    /// What a move has come to; empty when it is over.
    void told(const QString& sentence);

  private:
    struct Held {
        PickHandle handle;
        QPoint pressed;
        QPoint offset;  ///< from the cursor to the place that is picked
        bool dragging = false;
    };
    struct Nudge {
        PickHandle handle;
        QPoint aim;
        QSize size;                       ///< of the view that this is a pixel of
        int asked = 0;                    ///< answers that are still to come
        std::optional<ProbedPlace> last;  ///< what the keys have come to
        bool ending = false;              ///< enters the case with the last answer
    };
    std::optional<QPoint> aimOf(const SceneView& view, const PickHandle& handle) const;
    void propose(SceneView& view, const PickHandle& handle, const ProbedPlace& place);
    void withdraw(SceneView& view);
    void finish(SceneView& view, const PickHandle& handle, const ProbedPlace& place);
    QString refusal(const PickHandle& handle, const ProbedPlace& place) const;
    bool nudge(SceneView& view, const QPoint& step);
    void endNudge();
    void giveUp(SceneView& view);
    void follow();

    Document& document_;
    Selection& selection_;
    PickProbe& probe_;
    PickFeedback& feedback_;
    std::optional<PickHandle> pointed_;
    std::optional<PickHandle> active_;
    std::optional<Eigen::Vector3d> proposed_;  ///< where `active_` would go
    std::optional<Held> held_;
    std::optional<Nudge> nudge_;
    SceneView* nudgedIn_ = nullptr;
    QTimer nudgeTimer_;
    QCursor before_;  ///< the view's, while it tells of a handle
};

}  // namespace vestige
