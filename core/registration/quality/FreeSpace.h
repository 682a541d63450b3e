#pragma once

#include <optional>
#include <span>

#include "core/geometry/Pose.h"
#include "core/registration/quality/RangeImage.h"

namespace vestige {

/// How one cloud's surface, laid into the other, lies to the rays of the scanner there.
struct SightShares {
    double seen_m2 = 0;
    double through_m2 = 0;
    std::size_t cells = 0;  ///< seen or seen through

    /// Share of the area; 0 where nothing can be said.
    double through() const { return through_m2 > 0 ? through_m2 / (seen_m2 + through_m2) : 0; }
};

/// A cloud and the place it was scanned from, if that is known.
struct Sighted {
    std::span<const Eigen::Vector3f> points;
    std::span<const SurfaceCell> cells;
    /// The zero of the file's frame. It is believed only where the cloud bears it out: it lies within the
    /// bounds, the points lie more evenly over the directions from it than over the surface (a cloud that was
    /// fused, thinned or flown does not), and the rays do not go through the cloud's own surface.
    Eigen::Vector3d viewpoint;
};

/// Whether a scanner has seen through the place where a pose puts a surface.
class FreeSpace {
  public:
    /// `tolerance_m`: of surfaces that agree. Pieces thicker than that or larger than `largest_m`, which are
    /// what smaller ones left, do not count. A ray is past a surface when it ends more than four tolerances
    /// and a hundredth of the distance behind it.
    FreeSpace(const Sighted& target, const Sighted& source, double tolerance_m, double largest_m);

    /// The source's surface before the target's scanner and the other way round; nothing where that one's
    /// viewpoint is not known.
    std::optional<SightShares> fromTarget(const Pose& targetFromSource) const;
    std::optional<SightShares> fromSource(const Pose& targetFromSource) const;
    /// Whether both can be asked.
    bool known() const { return target_.image && source_.image; }
    /// The larger share of the two.
    double through(const Pose& targetFromSource) const;

  private:
    struct Side {
        std::optional<RangeImage> image;
        std::vector<SurfaceCell> cells;  ///< that its own scanner does not see through
    };
    Side sideOf(const Sighted& cloud) const;

    double tolerance_m_;
    double largest_m_;
    double margin_m_;
    Side target_;
    Side source_;
};

}  // namespace vestige
