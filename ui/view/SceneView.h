#pragma once

#include <QImage>
#include <QObject>
#include <QPoint>
#include <QRect>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/Picking.h"
#include "core/pipeline/ViewRenderer.h"
#include "ui/view/ViewMouse.h"
#include "ui/view/ViewPanes.h"
#include "ui/view/ViewSurface.h"
#include "ui/view/ViewTool.h"

class QMouseEvent;

namespace vestige {

struct ColorScale;
struct SectionHandle;

/// The 3D view: shows a ViewDescription on a surface, navigates, and picks with the one picking function of
/// core. Points are drawn coarse while the camera moves and complete when it stands still. It may be divided
/// into four panes with cameras of their own; tools get mouse events in the coordinates of the pane they are
/// in, whose camera is camera() then. GUI thread only.
class SceneView : public QObject {
    Q_OBJECT

  public:
    SceneView(const ViewSurfaceFactory& makeSurface, QWidget* parent);
    ~SceneView() override;

    /// Children of it (a floating tool bar) stand over the picture.
    QWidget* widget() const;

    /// Shows `view`; its camera is taken the first time and when `resetCamera`, else the present one stays.
    /// Layers whose geometry pointer and pose are unchanged are not uploaded again.
    void show(ViewDescription view, bool resetCamera = false);
    const ViewDescription& description() const;

    /// Octrees of the layers in `description().layers`, by the same index; what is hidden or cut away by the
    /// section takes no part.
    void setPickIndex(std::vector<std::shared_ptr<const Octree>> octrees);
    /// The pick at a position of the pane that has the mouse, in the camera shown now. What the section cuts
    /// away takes no part.
    std::optional<Pick> pickAt(const QPoint& position) const;

    /// Of the active pane; while an event is handled, of the pane it is in. Its size is the pane's.
    ViewCamera camera() const;
    void setCamera(const ViewCamera& camera);
    void showNamedView(NamedView view);

    void setLayout(ViewLayout layout);
    ViewLayout layout() const;
    /// Where the active pane lies in the widget (while an event is handled, the pane it is in).
    QRect panePlace() const;
    /// Gives every pane the camera that `change` makes of its present one.
    void changeCameras(const std::function<ViewCamera(const ViewCamera&)>& change);

    /// What lies outside is neither drawn nor picked; cheaper than show(). The picture is coarse until the
    /// section rests.
    void setSection(const std::optional<SectionBox>& section);
    /// Whether the section's handles are painted, and the one that the mouse holds.
    void showSectionHandles(bool on);
    void setHeldHandle(const std::optional<SectionHandle>& held);

    void setNavigation(NavigationPreset preset);
    /// What the view turns about; nothing: the point under the cursor. Shown as a small cross.
    void setPivot(const std::optional<Eigen::Vector3d>& pivot);
    const std::optional<Eigen::Vector3d>& pivot() const;
    /// To the point at a position of the pane that has the mouse (nothing there: back to the one under the
    /// cursor), or at where the mouse was last.
    void setPivotAt(const QPoint& position);
    void setPivotUnderCursor();

    /// The active tool; null for navigation alone. Not owned.
    void setTool(ViewTool* tool);
    ViewTool* tool() const;

    /// Sees mouse events before the active tool, and keys that this leaves; null for none. Not owned.
    void setGuard(ViewTool* guard);
    /// The same for handles that stand over the scene; after the guard.
    void setHandles(ViewTool* handles);

    /// Changes how the two pictures of the description's comparison are laid into each other; draws no point
    /// again. Nothing happens where the description has none.
    void setComparison(const ViewComparison& comparison);

    /// A pair in the making: the first end and the point under the cursor; nothing hides it.
    void setPendingMark(std::optional<ViewMark> mark);

    /// The tool's painting has changed.
    void updateOverlay();

    /// What the colours mean in the picture shown.
    const std::optional<ColorScale>& scale() const;

    /// What stands over the view (tool bars), in its pixels: legend and labels keep clear of it.
    void setCovered(std::vector<QRectF> covered);
    const std::vector<QRectF>& covered() const;

    /// Whether the picture shows everything there is to see from here.
    bool isComplete() const;
    /// Draws the complete picture in one step, unless it was drawn so: the same from run to run, which a
    /// picture built up step by step is but for points of equal depth.
    void completePicture();
    /// The complete picture, without the window round it. Null before the widget is shown.
    QImage grab();
    /// How long the last frame that was drawn while moving took, seconds; 0 before the first.
    double movingFrame_s() const;
    /// From where to where the colours run; nothing where they have no scale.
    std::optional<std::pair<double, double>> colorEnds() const;
    /// Points handed to the graphics card since the beginning: panes share them.
    std::uint64_t pointsUploaded() const;

  signals:
    void cameraChanged();
    void layoutChanged();
    void activePaneChanged();
    void colorsChanged();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool offerTo(ViewTool& tool, QEvent& event);
    bool handle(QEvent& event);

    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace vestige
