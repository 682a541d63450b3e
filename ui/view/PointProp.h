#pragma once

#include <vtkProp.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "ui/view/PointBlocks.h"
#include "ui/view/PointColors.h"
#include "ui/view/PointStore.h"

class vtkRenderer;
class vtkShaderProgram;

namespace vestige {

/// A point cloud in the VTK scene, drawn block by block from the pages that a PointStore holds. How much of
/// each block a frame draws is set before it.
class PointProp : public vtkProp {
  public:
    static PointProp* New();
    using Superclass = vtkProp;

    /// What is drawn. Positions are computed as pages are needed, in double relative to `displayOrigin`
    /// before they are rounded to float.
    void setPoints(std::shared_ptr<const PointCloud> cloud, PointBlocks blocks,
                   const Similarity& worldFromLayer, const Eigen::Vector3d& displayOrigin,
                   std::shared_ptr<PointStore> store);
    /// By index into the cloud; what was drawn in other colours is made again as it is needed.
    void setPainter(PointPainter painter);
    /// Points are drawn this large, and up to 2.5 times as large where they stand so far apart that a surface
    /// would be full of holes.
    void setPointSize(double pixels) { pointSize_ = pixels; }

    /// Draws the points as if they lay this much nearer to the camera: over what they coincide with.
    void setPull(double metres) { pull_m_ = metres; }

    /// In perspective points at the camera's focal point have the size set, nearer ones are larger, farther
    /// ones smaller.
    void setSizeByDistance(bool on) { sizeByDistance_ = on; }

    /// Half spaces of the display frame, normal and distance, of which each point must lie in all, six at
    /// most; inverted, those that do so are left out.
    void setClips(std::vector<Eigen::Vector4f> clips, bool inverted) {
        clips_ = std::move(clips);
        invertClips_ = inverted;
    }

    /// Moves the points from where setPoints() has them, in the display frame.
    void setMotion(const Eigen::Matrix4f& motion) { motion_ = motion; }

    const std::vector<PointBlock>& blocks() const { return blocks_.blocks(); }
    /// How many of each block's points the picture wants (0: not seen); as many as blocks().
    void setWanted(std::vector<std::uint32_t> wanted) { wanted_ = std::move(wanted); }
    const std::vector<std::uint32_t>& wanted() const { return wanted_; }
    /// The next frame draws this part of what is wanted, as shares of it. `whole`: what the store lacks is
    /// brought in; else it is left out.
    void setPart(double from, double to, bool whole);

    /// Whether the part [from, to) has points of a page of a block.
    bool needsPage(std::size_t block, std::uint32_t page, double from, double to) const;
    /// Pages that the part [from, to) needs and the store lacks.
    std::size_t pagesMissing(double from, double to) const;
    /// Whether the store holds the page; if so it stays for this frame.
    bool touchPage(std::size_t block, std::uint32_t page) {
        return store_->touch(places_, placeOf(block, page));
    }
    struct Page {
        std::size_t block;
        std::uint32_t page;
    };
    /// Makes these pages and puts them into the store, while it has room; false when it had none for some.
    bool bring(const std::vector<Page>& pages);

    /// While on, giving back one renderer's resources leaves the points on the card, for the others.
    void keepPages(bool on) { keepPages_ = on; }

    double* GetBounds() override { return bounds_; }
    int RenderOpaqueGeometry(vtkViewport* viewport) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

  protected:
    PointProp() = default;
    ~PointProp() override;

  private:
    static std::size_t placeOf(std::size_t block, std::uint32_t page) {
        return block * (PointBlocks::kSize / PointStore::kPage) + page;
    }
    void setUniforms(vtkShaderProgram& program, vtkRenderer& renderer) const;
    void drawBlocks(std::size_t first, std::size_t last) const;
    /// The block after those whose pages the store can hold at once.
    std::size_t endOfBatch(std::size_t first) const;

    std::shared_ptr<const PointCloud> cloud_;
    PointBlocks blocks_;
    Similarity worldFromLayer_;
    Eigen::Vector3d displayOrigin_ = Eigen::Vector3d::Zero();
    PointPainter painter_;
    std::shared_ptr<PointStore> store_;
    PointStore::Places places_;
    std::vector<std::uint32_t> wanted_;
    double from_ = 0;
    double to_ = 1;
    bool whole_ = true;
    bool keepPages_ = false;
    double pointSize_ = 2;
    double pull_m_ = 0;
    bool sizeByDistance_ = false;
    std::vector<Eigen::Vector4f> clips_;
    bool invertClips_ = false;
    Eigen::Matrix4f motion_ = Eigen::Matrix4f::Identity();
    double bounds_[6] = {-1, 1, -1, 1, -1, 1};
};

/// The first and last rank of the part [from, to) of `wanted` points.
struct RankRange {
    std::uint32_t first;
    std::uint32_t last;
};
RankRange rankRange(std::uint32_t wanted, double from, double to);

}  // namespace vestige
