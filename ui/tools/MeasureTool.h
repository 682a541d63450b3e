#pragma once

#include <QObject>
#include <QPoint>
#include <optional>

#include "core/geometry/Picking.h"
#include "core/scene/Measurement.h"
#include "ui/tools/HoverProbe.h"
#include "ui/view/ViewTool.h"

namespace vestige {

class Document;
class Notices;
class Selection;

/// Picks the two ends of a length: a click without dragging takes an end, the second completes one repeat of
/// the selected object (of a new one when none is selected). Dragging still turns the view. Esc, or the right
/// button without dragging, gives up the first end.
class MeasureTool : public QObject, public ViewTool {
    Q_OBJECT

  public:
    MeasureTool(Document& document, Selection& selection, Notices& notices, HoverProbe& probe,
                QObject* parent = nullptr);

    void enter(SceneView& view) override;
    void leave(SceneView& view) override;
    bool mousePress(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override;
    bool mouseRelease(SceneView& view, const QMouseEvent& event) override;
    bool keyPress(SceneView& view, const QKeyEvent& event) override;

    /// Gives up the first end.
    void abandon();

  signals:
    /// What the next click does.
    void hintChanged(const QString& hint);
    /// A pair was completed on an object that the pick created; its name wants editing.
    void objectCreated(const std::string& object);

  private:
    struct End {
        PickedPoint point;
        Eigen::Vector3d world;
    };
    std::optional<End> endAt(SceneView& view, const QPoint& position) const;
    void click(SceneView& view, const QPoint& position);
    void complete(const End& second);
    void showPending(const std::optional<Pick>& under);
    void tellHint();

    Document& document_;
    Selection& selection_;
    Notices& notices_;
    HoverProbe& probe_;
    SceneView* view_ = nullptr;
    std::optional<QPoint> pressed_;
    std::optional<End> first_;
};

}  // namespace vestige
