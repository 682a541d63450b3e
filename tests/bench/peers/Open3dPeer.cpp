// Open3D's point-to-plane ICP from raw points to the pose.
#include <omp.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/pipelines/registration/TransformationEstimation.h>
#include <stdlib.h>

#include "tests/bench/peers/Peer.h"

namespace {

using namespace vestige::bench;
namespace registration = open3d::pipelines::registration;

open3d::geometry::PointCloud cloudOf(const PeerCloud& points) {
    open3d::geometry::PointCloud cloud;
    cloud.points_.reserve(points.count);
    for (std::size_t i = 0; i < points.count; ++i)
        cloud.points_.emplace_back(points.xyz[3 * i], points.xyz[3 * i + 1], points.xyz[3 * i + 2]);
    return cloud;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void vestige_peer_open3d(const PeerRequest* request,
                                                                           PeerAnswer* answer) {
    // It heeds OpenMP's number of threads only where this variable is set.
    setenv("OMP_NUM_THREADS", request->threads == 1 ? "1" : "2", 1);
    omp_set_num_threads(request->threads);
    const auto target = cloudOf(request->target).VoxelDownSample(request->leaf_m);
    const auto source = cloudOf(request->source).VoxelDownSample(request->leaf_m);
    target->EstimateNormals(open3d::geometry::KDTreeSearchParamKNN(20));
    const Eigen::Matrix4d start = Eigen::Map<const Eigen::Matrix4d>(request->start);
    const auto result = registration::RegistrationICP(*source, *target, 1.0, start,
                                                      registration::TransformationEstimationPointToPlane(),
                                                      registration::ICPConvergenceCriteria(1e-6, 1e-6, 100));
    answer->iterations = 0;
    Eigen::Map<Eigen::Matrix4d>(answer->targetFromSource) = result.transformation_;
}
