#pragma once

#include <QObject>
#include <QPoint>
#include <optional>
#include <vector>

#include "core/geometry/Picking.h"
#include "core/scene/Measurement.h"
#include "ui/tools/HoverProbe.h"
#include "ui/view/ViewTool.h"

namespace vestige {

class Document;
class Notices;
class Selection;
struct KindSpec;

/// Picks the points of a kind of measurement: a click without dragging adds a point; a kind of a fixed number
/// of points ends with the last of them, others with a double click, the right button without dragging, or
/// Enter. Backspace takes the last point away, Esc gives up. Dragging turns the view, and with Alt held no
/// press is a click. What is ended becomes a repeat of the selected object where that is of the tool's kind,
/// else of a new one.
class PathTool : public QObject, public ViewTool {
    Q_OBJECT

  public:
    PathTool(Document& document, Selection& selection, Notices& notices, HoverProbe& probe,
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
    /// What the next click does.
    void hintChanged(const QString& hint);
    /// A path was completed on an object that it created; its name wants editing.
    void objectCreated(const std::string& object);

  private:
    const KindSpec& spec() const;
    void click(SceneView& view, const QPoint& position);
    void finish();
    void complete();
    void takeBack();
    void abandon();
    void showPending(const std::optional<Pick>& under);
    void tellHint();

    Document& document_;
    Selection& selection_;
    Notices& notices_;
    HoverProbe& probe_;
    MeasurementKind kind_ = MeasurementKind::polyline;
    SceneView* view_ = nullptr;
    std::optional<QPoint> pressed_;
    PickedPath points_;
    std::vector<Eigen::Vector3d> world_;  ///< where they are shown
};

}  // namespace vestige
