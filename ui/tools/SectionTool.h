#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "core/geometry/SectionBox.h"
#include "ui/view/SectionFrame.h"
#include "ui/view/ViewTool.h"

namespace vestige {

class Presentation;

/// The mouse on the section box: faces are dragged along their axis, the ring turns the box, Ctrl and wheel
/// move a slab by its thickness.
class SectionTool : public QObject, public ViewTool {
    Q_OBJECT

  public:
    explicit SectionTool(Presentation& presentation, QObject* parent = nullptr);

    bool mousePress(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override;
    bool mouseRelease(SceneView& view, const QMouseEvent& event) override;
    bool wheel(SceneView& view, const QWheelEvent& event) override;

    /// Moves the section by its thickness along its thinnest axis.
    void step(int direction);

  private:
    void drag(const SceneView& view, const QPointF& position);

    Presentation& presentation_;
    std::optional<SectionHandle> held_;
    SectionBox begun_;
    QPointF pressed_;
    bool pointing_ = false;
};

}  // namespace vestige
