#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/filters/GroundGrid.h"
#include "core/filters/UprightPoints.h"

namespace vestige {

struct GroundOptions {
    double cell_m = 0.5;
    double widest_m = 18;                              ///< of what stands on the ground
    double slope = 0.15;                               ///< rise over run
    std::optional<double> tolerance_m = std::nullopt;  ///< nothing: 3 times the scatter, 0.02 m to 0.15 m
};

/// The ground under a cloud as small planes, one for each square of a grid.
class GroundSurface {
  public:
    struct Plane {
        float height = 0;  ///< at the square's middle
        float alongX = 0;  ///< rise over run
        float alongY = 0;
        float tolerance = 0;  ///< m
    };
    GroundSurface(GroundGrid grid, std::vector<Plane> planes)
        : grid_(std::move(grid)), planes_(std::move(planes)) {}

    /// Metres above the ground of a place of UprightPoints; below 0: beneath it.
    float heightAbove(const Eigen::Vector3f& place) const {
        const std::size_t at = grid_.index(place.x(), place.y());
        const Eigen::Vector2f aside = place.head<2>() - grid_.centre(at);
        const Plane& plane = planes_[at];
        return place.z() - plane.height - plane.alongX * aside.x() - plane.alongY * aside.y();
    }
    /// How near to the ground a point there has to be to belong to it.
    float tolerance(const Eigen::Vector3f& place) const {
        return planes_[grid_.index(place.x(), place.y())].tolerance;
    }

  private:
    GroundGrid grid_;
    std::vector<Plane> planes_;
};

/// Finds the ground below cars, walls and trees: the lowest point of each square; morphological openings with
/// growing squares, which leave out what rises more than the slope allows for their size (Zhang and others,
/// IEEE Trans. Geosci. Remote Sens. 41, 2003; the steps of Pingel, Clarke and McBride, ISPRS J. 77, 2013);
/// then planes fitted to the points near what is left, four times, with the scatter of the points round them.
/// Deterministic. ErrorCode::input for an empty cloud, ErrorCode::usage for a grid of more than 2^22 squares,
/// ErrorCode::cancelled.
Result<GroundSurface> findGround(const UprightPoints& points, const GroundOptions& options,
                                 const JobControl& control = {});

/// The points that belong to it, by ascending index.
std::vector<std::uint32_t> groundPoints(const UprightPoints& points, const GroundSurface& ground);

}  // namespace vestige
