#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/simulation/SurfaceModel.h"

namespace vestige {

/// Nearest face along a ray.
struct RayHit {
    float distance = 0;
    std::uint32_t face = 0;  ///< index into the model's faces
};

/// Finds what a ray meets first: a bounding volume hierarchy over a model's faces, split by the surface-area
/// heuristic in 16 bins (Wald 2007); Moeller-Trumbore for the faces. Metres in the model's frame, single
/// precision: good to 4 micrometres at 60 m. Immutable; any thread may cast.
class RayTracer {
  public:
    explicit RayTracer(const SurfaceModel& model);

    /// Nothing when no face lies between `nearest` and `farthest` metres along the unit vector `direction`.
    std::optional<RayHit> cast(const Eigen::Vector3f& from, const Eigen::Vector3f& direction, float nearest,
                               float farthest) const;
    /// True when nothing lies between the two points but their last `margin` metres at either end.
    bool sees(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float margin) const;
    /// Unit normal of a face; its side is arbitrary.
    const Eigen::Vector3f& normal(std::uint32_t face) const { return normals_[face]; }

  private:
    struct Node {
        Eigen::Vector3f min;
        std::uint32_t first;  ///< first child (second is next to it), or first corner set of a leaf
        Eigen::Vector3f max;
        std::uint32_t count;  ///< faces of a leaf; 0 for an inner node
    };
    struct Corner {
        Eigen::Vector3f a;
        Eigen::Vector3f ab;
        Eigen::Vector3f ac;
        std::uint32_t face;
    };
    struct BuildItem;

    void build(std::vector<BuildItem>& items, std::uint32_t node, std::uint32_t begin, std::uint32_t end);

    std::vector<Node> nodes_;
    std::vector<Corner> corners_;
    std::vector<Eigen::Vector3f> normals_;
};

}  // namespace vestige
