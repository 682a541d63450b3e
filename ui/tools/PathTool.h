#pragma once

#include <QObject>
#include <QPoint>
#include <optional>
#include <vector>

#include "core/scene/Measurement.h"
#include "ui/tools/PickAids.h"
#include "ui/tools/PickHandles.h"
#include "ui/tools/ProbedPlace.h"
#include "ui/view/ViewTool.h"

namespace vestige {

class Document;
class Notices;
class Selection;
struct KindSpec;

/// Picks the points of a kind of measurement, snapped as chosen: a click without dragging adds a point; a
/// kind of a fixed number of points ends with the last of them, others with a double click, the right button
/// without dragging, or Enter. Backspace takes the last point away, Esc gives up; with nothing begun Esc and
/// the right button leave the tool. Dragging turns the view, but on a point of a repeat, which it moves while
/// no path is begun; with Alt it turns the view there, too, and a click picks nothing. What is ended becomes
/// a repeat of the selected object where that is of the tool's kind, else of a new one.
class PathTool : public QObject, public ViewTool {
    Q_OBJECT

  public:
    PathTool(Document& document, Selection& selection, Notices& notices, const PickAids& aids,
             QObject* parent = nullptr);

    /// What is picked from now on; gives up what was begun.
    void setKind(MeasurementKind kind);
    MeasurementKind kind() const { return kind_; }

    void enter(SceneView& view) override;
    void leave(SceneView& view) override;
    bool mousePress(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override;
    bool mouseRelease(SceneView& view, const QMouseEvent& event) override;
    bool mouseDoubleClick(SceneView& view, const QMouseEvent& event) override;
    bool holdsKey(const SceneView& view, const QKeyEvent& event) const override;
    void paint(const SceneView& view, QPainter& painter, const ViewCamera& camera,
               const ViewTheme& theme) const override;
    bool keyPress(SceneView& view, const QKeyEvent& event) override;

    std::size_t picked() const { return points_.size(); }

  signals:
    /// What the next click does, and below it what the last one came to.
    void hintChanged(const QString& hint);
    /// A path was completed on an object that it created; its name wants editing.
    void objectCreated(const std::string& object);
    /// The user is done with it.
    void finished();

  private:
    const KindSpec& spec() const;
    /// The selected object where the next repeat is one of it.
    const Measurement* again() const;
    bool begun() const { return !points_.empty() || waiting_ > 0; }
    void click(SceneView& view, const QPoint& position);
    void take(const ProbedPlace& place);
    void finish();
    void complete();
    void takeBack();
    void abandon();
    void forgetClicks();
    void show(const ProbedPlace& place);
    void showPending(const std::optional<Eigen::Vector3d>& under);
    void tellHint();
    QString below() const;

    Document& document_;
    Selection& selection_;
    Notices& notices_;
    PickAids aids_;
    MeasurementKind kind_ = MeasurementKind::polyline;
    SceneView* view_ = nullptr;
    std::optional<QPoint> pressed_;
    std::vector<ProbedPick> points_;
    int waiting_ = 0;      ///< clicks whose answers are still to come
    bool ending_ = false;  ///< the path ends with the last of them
    int forgotten_ = 0;    ///< clicks that were not answered before are not wanted
    QString problem_;      ///< why a click would take nothing, or what a move has come to
};

}  // namespace vestige
