#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/Random.h"
#include "core/simulation/RayTracer.h"
#include "core/survey/Sensors.h"

namespace vestige {

/// One echo of a pulse, before noise.
struct Echo {
    double range_m = 0;  ///< energy-weighted mean over the part of the spot that made it
    double energy = 0;   ///< share of the pulse's energy that comes back from a white, facing target
    Eigen::Vector3f truth = Eigen::Vector3f::Zero();  ///< where its strongest ray met the surface, site frame
    std::uint16_t part = 0;                           ///< and on what
};

/// What one pulse of a laser scanner brings back. The beam is seven rays across the long side of its spot,
/// weighted by a Gaussian; where the outer and the middle ray meet one part at matching ranges the others are
/// not cast. Rays whose ranges differ by less than the sheet's resolution make one echo (so that points float
/// at edges), the rest further echoes; up to the sheet's number of the strongest come back, nearest first.
/// Glass lets rays pass, mirrors them away or, rarely, answers.
class Footprint {
  public:
    Footprint(const RayTracer& tracer, const SurfaceModel& surfaces, const AirborneLidarSheet& sheet);

    /// `siteFromSensor`: columns are the beam (unit), and the long and the short side of the spot, site
    /// frame.
    void echoes(const Eigen::Vector3d& from, const Eigen::Matrix3d& siteFromBeam, Random& random,
                std::vector<Echo>& found) const;

  private:
    struct Ray {
        double range_m = 0;
        double energy = 0;
        Eigen::Vector3f truth = Eigen::Vector3f::Zero();
        std::uint16_t part = 0;
        bool hit = false;
        bool plain = false;  ///< met one opaque surface
    };
    Ray castRay(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, Random& random) const;

    const RayTracer& tracer_;
    const SurfaceModel& surfaces_;
    const AirborneLidarSheet& sheet_;
};

}  // namespace vestige
