#pragma once

#include <cstdint>

#include "core/simulation/RayTracer.h"
#include "core/simulation/SurfaceModel.h"

namespace vestige {

/// What a simulated tripod scanner stands in; all made from a seed, in the scanner's working range.
enum class TripodSceneKind {
    street,   ///< an accident: crowned road, kerbs, five cars, barrier, poles, trees, facades, debris
    hall,     ///< a parking hall with rows of columns that look alike, three cars
    field,    ///< bumpy ground with trees and boulders, nothing flat
    bareRoad  ///< only the crowned road with kerbs: a scan can slide along it
};

struct TripodSceneOptions {
    TripodSceneKind kind = TripodSceneKind::street;
    std::uint64_t seed = 1;  ///< where things stand, their sizes, the facades
};

/// The surfaces of a scene, site frame: metres, x along the road, z up, the origin in the middle of the road.
SurfaceModel buildTripodScene(const TripodSceneOptions& options);

/// Surfaces with what casts rays at them: made once, scanned from any number of stations.
class TripodScene {
  public:
    explicit TripodScene(const TripodSceneOptions& options)
        : surfaces_(buildTripodScene(options)), tracer_(surfaces_) {}

    const SurfaceModel& surfaces() const { return surfaces_; }
    const RayTracer& tracer() const { return tracer_; }

  private:
    SurfaceModel surfaces_;
    RayTracer tracer_;
};

}  // namespace vestige
