#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QPoint>
#include <optional>
#include <vector>

#include "ui/tools/HoverProbe.h"
#include "ui/view/ViewTool.h"

namespace vestige {

class OutlineOverlay;

/// Draws an outline over the picture. A lasso: each click is a corner, dragging draws by free hand; a double
/// click, the right button, Return or a click on the first corner closes it, and so does letting go of a
/// stroke that began it. A box: two opposite corners, by dragging or two clicks. Backspace takes the last
/// corner away, Esc gives up. With Alt held, and with the wheel, the view is navigated; the outline stays
/// where it is on the screen.
class OutlineTool : public QObject, public ViewTool {
    Q_OBJECT

  public:
    enum class Shape { lasso, box };
    OutlineTool(Shape shape, HoverProbe& probe, QObject* parent = nullptr);
    ~OutlineTool() override;

    void enter(SceneView& view) override;
    void leave(SceneView& view) override;
    bool mousePress(SceneView& view, const QMouseEvent& event) override;
    bool mouseMove(SceneView& view, const QMouseEvent& event) override;
    bool mouseRelease(SceneView& view, const QMouseEvent& event) override;
    bool mouseDoubleClick(SceneView& view, const QMouseEvent& event) override;
    bool keyPress(SceneView& view, const QKeyEvent& event) override;

    /// Gives up the outline.
    void abandon();
    Shape shape() const { return shape_; }
    std::size_t cornerCount() const { return corners_.size(); }

  signals:
    /// What the next click does.
    void hintChanged(const QString& hint);
    /// In pixels of the view; three corners or more.
    void closed(const std::vector<Eigen::Vector2d>& corners, Qt::KeyboardModifiers modifiers);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void add(const QPoint& place);
    void takeBack();
    void close(Qt::KeyboardModifiers modifiers);
    bool onFirst(const QPoint& place) const;
    std::vector<QPoint> outline() const;
    void show();

    Shape shape_;
    HoverProbe& probe_;
    SceneView* view_ = nullptr;
    OutlineOverlay* overlay_ = nullptr;
    std::vector<QPoint> corners_;
    std::optional<QPoint> cursor_;
    std::optional<QPoint> pressed_;
    bool stroke_ = false;   ///< the button is down and draws by free hand
    bool began_ = false;    ///< by the press that is still down
    bool passing_ = false;  ///< this press navigates
};

}  // namespace vestige
