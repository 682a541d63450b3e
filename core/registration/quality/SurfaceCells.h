#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace vestige {

/// A piece of a cloud's surface: the points of one voxel that lie on a plane. Metres.
struct SurfaceCell {
    Eigen::Vector3d mean;
    Eigen::Vector3d normal;  ///< unit; which way it points means nothing
    Eigen::Vector3d wide;    ///< unit, in the plane, along the larger extent
    double thickness_m = 0;  ///< standard deviation across the plane
    double wide_m = 0;       ///< standard deviation along `wide`
    double narrow_m = 0;     ///< and across it, in the plane
    double size_m = 0;       ///< edge of the voxel
    double area_m2 = 0;      ///< what the cell stands for: about the surface that its points cover
    double count = 0;

    /// Variance (m^2) of the plane's height over its own points' mean, at an offset from it: of a plane
    /// fitted to `count` points with independent noise of `thickness_m`.
    double planeVariance(const Eigen::Vector3d& offset) const;
};

/// Splits a cloud into planar cells: voxels of `finest_m` that hold a plane, then the points that are left in
/// voxels twice as large, and so on for `levels` sizes. Points that lie on no plane at any size are dropped.
/// The same bits for any number of threads.
std::vector<SurfaceCell> surfaceCells(std::span<const Eigen::Vector3f> points, double finest_m, int levels);

/// The thickness (standard deviation, metres) that a quarter of the cloud's voxels of this edge stay below:
/// what its noise looks like where it is flat. 0 for a cloud without filled voxels.
double flattestQuarter(std::span<const Eigen::Vector3f> points, double size_m);

/// Finds the cell of a cloud whose plane a place lies on.
class SurfaceIndex {
  public:
    SurfaceIndex(std::vector<SurfaceCell> cells, double finest_m, int levels);

    const std::vector<SurfaceCell>& cells() const { return cells_; }
    /// The cell whose plane passes nearest to x, among those whose normal is within the angle of cosine
    /// `cosine` to `normal` and whose middle is within 0.75 of their size of x, along the plane and across
    /// it; smaller cells before larger ones. Null where there is none. `any`, if given, becomes the one for a
    /// cosine of 0 where there is none for `cosine`.
    const SurfaceCell* over(const Eigen::Vector3d& x, const Eigen::Vector3d& normal, double cosine,
                            const SurfaceCell** any = nullptr) const;

  private:
    /// The cells of one size by the voxel of their mean and by those round it: open addressing.
    struct Level {
        struct Entry {
            std::uint64_t key;
            std::uint32_t cell;
        };
        std::vector<Entry> table;
        std::uint32_t mask = 0;
    };
    std::vector<SurfaceCell> cells_;
    double finest_m_;
    std::vector<Level> levels_;
};

}  // namespace vestige
