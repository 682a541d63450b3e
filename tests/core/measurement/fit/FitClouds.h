#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <vector>

#include "core/base/Random.h"
#include "core/geometry/Octree.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/measurement/fit/Snap.h"

namespace vestige::fit_test {

/// Surfaces sampled at random, each point moved along a beam.
class Cloud {
  public:
    Cloud(std::uint64_t seed, double noise_m) : random_(seed, 1), noise_(noise_m) {}

    /// `count` points of the parallelogram from `corner` along `u` and `v`, seen along `beam`.
    void patch(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v, int count,
               const Eigen::Vector3d& beam) {
        for (int i = 0; i < count; ++i) add(corner + random_.uniform() * u + random_.uniform() * v, beam);
    }
    /// Points of a ring.
    void ring(const Eigen::Vector3d& centre, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
              double radius, int count, const Eigen::Vector3d& beam) {
        for (int i = 0; i < count; ++i) {
            const double angle = random_.uniform(0, 6.283185307179586);
            add(centre + radius * (std::cos(angle) * u + std::sin(angle) * v), beam);
        }
    }
    void add(const Eigen::Vector3d& point, const Eigen::Vector3d& beam) {
        points_.push_back(point + random_.normal(0, noise_) * beam.normalized());
    }

    std::shared_ptr<const Octree> octree() const {
        PointCloudBuilder builder(Eigen::Vector3d(500000, 4300000, 0));
        for (const auto& point : points_) builder.add(Eigen::Vector3d(500000, 4300000, 0) + point);
        return std::make_shared<const Octree>(std::make_shared<const PointCloud>(std::move(builder).build()));
    }
    Random& random() { return random_; }

  private:
    Random random_;
    double noise_;
    std::vector<Eigen::Vector3d> points_;
};

inline const Eigen::Vector3d kOrigin(500000, 4300000, 0);

inline SnapRequest request(const Octree& octree, const Eigen::Vector3d& seed, double noise_m,
                           const Eigen::Vector3d& view = {0, 0, -1}) {
    SnapRequest asked;
    asked.octree = &octree;
    asked.seed = kOrigin + seed;
    asked.viewDirection = view.normalized();
    asked.sensorNoise_m = noise_m;
    return asked;
}

}  // namespace vestige::fit_test
