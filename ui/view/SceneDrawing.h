#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ui/view/ColorScale.h"
#include "ui/view/VtkCamera.h"

class vtkRenderWindow;
class QRectF;

namespace vestige {

/// The VTK scene of a description in one render window: what is shown, from where, and how much of the points
/// a frame adds. The window's owner draws the frames.
class SceneDrawing {
  public:
    /// Points that the graphics card holds at most: 400 MB of them, a tenth of what a small card has, and
    /// several times what a picture of 4 million pixels needs.
    static constexpr std::size_t kMostHeld = std::size_t{24} << 20;
    /// While the blocks that are seen have fewer points than this, all of them are drawn; beyond, those that
    /// the picture's pixels can show. As many as the card holds with room to spare: where points lie
    /// unevenly, as at the edge of a flight, thinning shows.
    static constexpr std::size_t kWholeBelow = 20000000;

    /// The window must outlive this object.
    explicit SceneDrawing(vtkRenderWindow& window, std::size_t mostHeld = kMostHeld,
                          std::size_t wholeBelow = kWholeBelow);
    ~SceneDrawing();

    /// Divides the window: a picture for each viewport, shares of it from the top left. At first there is one
    /// that fills the window.
    void setPanes(const std::vector<QRectF>& viewports);
    /// The picture that all that follows is about, but show() and setComparison(): 0 for the first. The
    /// others stay as they are.
    void usePane(std::size_t pane);

    /// Rebuilds what differs from what is there; a layer that was moved is moved, not built again. A layer
    /// without an octree gets one here. The description's camera is not taken.
    void show(const ViewDescription& view);
    /// What lies outside is not drawn; the pictures must begin anew.
    void setSection(const std::optional<SectionBox>& section);
    void setCamera(const ViewCamera& camera);
    /// The window shows a part of the camera's picture only.
    void setCamera(const ViewCamera& camera, const PictureTile& tile);

    /// How the two pictures of a comparison are laid into each other; costs no drawing of points. The
    /// description shown says whether there are two.
    void setComparison(const ViewComparison& comparison);

    /// Points that the picture needs to be complete.
    std::size_t pointsWanted() const;
    /// Points that the graphics card was given since the beginning, and those it holds.
    std::uint64_t pointsUploaded() const;
    std::size_t pointsHeld() const;

    /// The largest share up to `to` for which the part from `from` asks for about `most` points that are not
    /// held yet; more than `from` in any case.
    double shareWithin(double from, double to, std::size_t most) const;
    /// The next frame shows the meshes and the first `share` (0 to 1) of the points wanted.
    void beginPicture(double share);
    /// Like beginPicture(), for a picture that will be replaced at once: brings at most about `most` points
    /// to the graphics card, the first of each block first, and leaves out what it does not hold. True when
    /// that is nothing.
    bool beginPassingPicture(double share, std::size_t most);
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
