#include "core/measurement/TransformedFeature.h"

namespace vestige {

FittedFeature transformed(const Similarity& to, const FittedFeature& feature) {
    FittedFeature moved = feature;
    const Eigen::Matrix3d turn = to.pose.linear();
    moved.position = to * feature.position;
    moved.axis = turn * feature.axis;
    moved.covariance = to.scale * to.scale * (turn * feature.covariance * turn.transpose());
    moved.radius = to.scale * feature.radius;
    moved.radiusUncertainty = to.scale * feature.radiusUncertainty;
    moved.rms = to.scale * feature.rms;
    return moved;
}

}  // namespace vestige
