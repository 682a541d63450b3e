#pragma once

#include <memory>

#include "core/geometry/Octree.h"
#include "ui/view/ColorScale.h"

class vtkRenderWindow;

namespace vestige {

/// The VTK scene of a description in one render window: what is shown, from where, and how much of the points
/// a frame adds. The window's owner draws the frames.
class SceneDrawing {
  public:
    /// The window must outlive this object.
    explicit SceneDrawing(vtkRenderWindow& window);
    ~SceneDrawing();

    /// Rebuilds what differs from what is there; a layer that was moved is moved, not built again. `octrees`
    /// (by the layers' index, may be empty) save sorting the points. The description's camera is not taken.
    void show(const ViewDescription& view, const std::vector<std::shared_ptr<const Octree>>& octrees = {});
    void setCamera(const ViewCamera& camera);

    /// How the two pictures of a comparison are laid into each other; costs no drawing of points. The
    /// description shown says whether there are two.
    void setComparison(const ViewComparison& comparison);

    /// Points of the blocks that the camera may see.
    std::size_t pointsSeen() const;
    /// The next frame shows the meshes and the first `share` (0 to 1) of the points seen.
    void beginPicture(double share);
    /// The next frame adds points to the last one, up to `share`. Only while the camera and the description
    /// stay the same.
    void addToPicture(double share);

    /// What the colours mean.
    const std::optional<ColorScale>& scale() const;

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace vestige
