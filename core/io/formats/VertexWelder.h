#pragma once

#include <array>
#include <unordered_map>

#include "core/geometry/PointCloudBuilder.h"
#include "core/geometry/TriangleMesh.h"
#include "core/io/ReadJob.h"

namespace vestige {

/// Makes a mesh of triangles given corner by corner: corners of exactly equal coordinates become one vertex.
class VertexWelder {
  public:
    explicit VertexWelder(ReadJob& job) : job_(job) {}
    void add(const Eigen::Vector3d& corner);
    std::size_t corners() const { return corners_; }
    /// Triangles with two equal corners are left out with a warning. Leaves the welder empty.
    TriangleMesh build() &&;

  private:
    using Key = std::array<double, 3>;
    /// Seeded anew by each run, so that no file can be made whose vertices all fall into one bucket. The mesh
    /// does not depend on it.
    struct Hash {
        Hash();
        std::uint64_t seed;
        std::size_t operator()(const Key& key) const;
    };

    ReadJob& job_;
    std::unordered_map<Key, std::uint32_t, Hash> indices_;
    PointCloudBuilder builder_;
    std::vector<Triangle> triangles_;
    Triangle triangle_{};
    std::size_t corners_ = 0;
    std::size_t flat_ = 0;
};

}  // namespace vestige
