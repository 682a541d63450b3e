#pragma once

#include <QObject>
#include <QPoint>
#include <optional>

#include "core/scene/Measurement.h"
#include "ui/tools/PickAids.h"
#include "ui/tools/PickHandles.h"
#include "ui/tools/ProbedPlace.h"
#include "ui/view/ViewTool.h"

namespace vestige {

class Document;
class Selection;

/// Picks the two ends of a length: a click without dragging takes an end, the second completes one repeat of
/// the selected object (of a new one when none is selected, or that is no pair of ends). Dragging turns the
/// view, but on the end of a repeat, which it moves; with Alt it turns the view there, too, and a click picks
/// nothing. Esc or a right click gives up the first end; without one, they leave the tool, as does a double
/// click that ends a pair.
class MeasureTool : public QObject, public ViewTool {
    Q_OBJECT

  public:
    MeasureTool(Document& document, Selection& selection, const PickAids& aids, QObject* parent = nullptr);

    void enter(SceneView& view) override;
    void leave(SceneView& view) override;
    bool mousePress(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override;
    bool mouseRelease(SceneView& view, const QMouseEvent& event) override;
    bool mouseDoubleClick(SceneView& view, const QMouseEvent& event) override;
    bool keyPress(SceneView& view, const QKeyEvent& event) override;
    bool holdsKey(const SceneView& view, const QKeyEvent& event) const override;
    void paint(const SceneView& view, QPainter& painter, const ViewCamera& camera,
               const ViewTheme& theme) const override;

    /// Gives up the first end.
    void abandon();

  signals:
    /// What the next click does, and below it what the last one came to.
    void hintChanged(const QString& hint);
    /// A pair was completed on an object that the pick created; its name wants editing.
    void objectCreated(const std::string& object);
    /// The user is done with it.
    void finished();

  private:
    /// The selected object where the next pair is a repeat of it.
    const Measurement* again() const;
    void click(SceneView& view, const QPoint& position);
    void take(const ProbedPlace& place);
    void complete(const ProbedPick& second);
    void show(const ProbedPlace& place);
    void showPending(const std::optional<Eigen::Vector3d>& under);
    void tellHint();

    Document& document_;
    Selection& selection_;
    PickAids aids_;
    SceneView* view_ = nullptr;
    std::optional<QPoint> pressed_;
    std::optional<ProbedPick> first_;
    std::optional<PickHandle> last_;  ///< the end that was picked last
    int abandoned_ = 0;               ///< clicks that were not answered before are not wanted
    bool completing_ = false;         ///< the last click ended a pair
    QString problem_;                 ///< why a click would take nothing, or what a move has come to
};

}  // namespace vestige
