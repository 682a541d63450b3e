#include "core/geometry/BoundingBox.h"

namespace vestige {

void BoundingBox::add(const Eigen::Vector3d& point) {
    min = min.cwiseMin(point);
    max = max.cwiseMax(point);
}

void BoundingBox::add(const BoundingBox& other) {
    min = min.cwiseMin(other.min);
    max = max.cwiseMax(other.max);
}

BoundingBox BoundingBox::transformed(const Similarity& toFromHere) const {
    BoundingBox moved;
    if (empty()) return moved;
    for (int corner = 0; corner < 8; ++corner)
        moved.add(toFromHere * Eigen::Vector3d((corner & 1) ? max.x() : min.x(),
                                               (corner & 2) ? max.y() : min.y(),
                                               (corner & 4) ? max.z() : min.z()));
    return moved;
}

}  // namespace vestige
