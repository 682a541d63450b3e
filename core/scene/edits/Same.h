#pragma once

#include "core/geometry/Pose.h"
#include "core/geometry/ViewCamera.h"

namespace vestige {

/// Equal to the last bit.
inline bool same(const Similarity& a, const Similarity& b) {
    return a.scale == b.scale && a.pose.matrix() == b.pose.matrix();
}

inline bool same(const ViewCamera& a, const ViewCamera& b) {
    return a.position == b.position && a.focalPoint == b.focalPoint && a.viewUp == b.viewUp &&
           a.parallel == b.parallel && a.verticalAngle_rad == b.verticalAngle_rad &&
           a.halfHeight_m == b.halfHeight_m && a.width_px == b.width_px && a.height_px == b.height_px;
}

}  // namespace vestige
