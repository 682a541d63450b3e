#pragma once

#include <QImage>
#include <QObject>
#include <QPoint>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/Picking.h"
#include "core/pipeline/ViewRenderer.h"
#include "ui/view/ViewSurface.h"
#include "ui/view/ViewTool.h"

namespace vestige {

struct ColorScale;

/// The 3D view: shows a ViewDescription on a surface, navigates, and picks with the one picking function of
/// core. Points are drawn coarse while the camera moves and complete when it stands still. GUI thread only.
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
    /// The pick at a position of the widget, in the camera shown now.
    std::optional<Pick> pickAt(const QPoint& position) const;

    ViewCamera camera() const;
    void setCamera(const ViewCamera& camera);
    void showNamedView(NamedView view);

    /// The active tool; null for navigation alone. Not owned.
    void setTool(ViewTool* tool);
    ViewTool* tool() const;

    /// Sees mouse events before the active tool, and keys that this leaves; null for none. Not owned.
    void setGuard(ViewTool* guard);

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

  signals:
    void cameraChanged();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool offerTo(ViewTool& tool, QEvent& event);

    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace vestige
