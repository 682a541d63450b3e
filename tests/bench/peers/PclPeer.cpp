// PCL's methods from raw points to the pose. Compiled three times, the function named by PEER_ENTRY: as a
// user of the distribution's package compiles it (the method's template here, for any x86-64; kd-tree and
// voxel grids from the distribution's binaries); with PCL_NO_PRECOMPILE, so that every template gets our
// flags; and with PEER_FROM_LIBRARY, NDT as the distribution's library holds it.
#include <pcl/console/print.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/ndt.h>

#include <stdexcept>

#include "tests/bench/peers/Peer.h"

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;

#ifdef PEER_FROM_LIBRARY
extern template class pcl::NormalDistributionsTransform<Point, Point>;
#endif

namespace {

using namespace vestige::bench;

constexpr float kNdtSourceLeaf_m = 0.1F;
constexpr double kPairDistance_m = 1.0;
constexpr int kIterations = 100;

Cloud::Ptr cloudOf(const PeerCloud& points) {
    Cloud::Ptr cloud(new Cloud);
    cloud->resize(points.count);
    for (std::size_t i = 0; i < points.count; ++i) {
        Point& point = (*cloud)[i];
        point.x = points.xyz[3 * i];
        point.y = points.xyz[3 * i + 1];
        point.z = points.xyz[3 * i + 2];
    }
    return cloud;
}

Cloud::Ptr thinned(const Cloud::Ptr& cloud, float leaf) {
    pcl::VoxelGrid<Point> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(leaf, leaf, leaf);
    Cloud::Ptr thin(new Cloud);
    grid.filter(*thin);
    // PCL hands back the cloud as it was when its cell numbers overflow.
    if (thin->size() == cloud->size() && cloud->size() > 100000)
        throw std::runtime_error("pcl::VoxelGrid did not filter");
    return thin;
}

template <class Method>
Eigen::Matrix4f aligned(Method& method, const Cloud::Ptr& target, const Cloud::Ptr& source,
                        const Eigen::Matrix4f& start) {
    method.setInputTarget(target);
    method.setInputSource(source);
    Cloud output;
    method.align(output, start);
    return method.getFinalTransformation();
}

Eigen::Matrix4f ndt(const Cloud::Ptr& target, const Cloud::Ptr& source, const Eigen::Matrix4f& start,
                    float leaf, int& iterations) {
    pcl::NormalDistributionsTransform<Point, Point> method;
    method.setTransformationEpsilon(1e-4);  // of the squared step: 0.01 m
    method.setStepSize(0.1);
    method.setResolution(leaf);
    method.setMaximumIterations(kIterations);
    const Eigen::Matrix4f found = aligned(method, target, source, start);
    iterations += method.getFinalNumIteration();
    return found;
}

Eigen::Matrix4f icp(const Cloud::Ptr& target, const Cloud::Ptr& source, const Eigen::Matrix4f& start,
                    int& iterations) {
    pcl::IterativeClosestPoint<Point, Point> method;
    method.setMaxCorrespondenceDistance(kPairDistance_m);
    method.setMaximumIterations(kIterations);
    method.setTransformationEpsilon(1e-6);              // of the squared step: 1 mm
    method.setTransformationRotationEpsilon(1 - 6e-8);  // cosine of 0.02 degrees
    const Eigen::Matrix4f found = aligned(method, target, source, start);
    iterations += method.nr_iterations_;
    return found;
}

Eigen::Matrix4f gicp(const Cloud::Ptr& target, const Cloud::Ptr& source, const Eigen::Matrix4f& start,
                     double pairDistance_m) {
    pcl::GeneralizedIterativeClosestPoint<Point, Point> method;
    method.setMaxCorrespondenceDistance(pairDistance_m);
    method.setMaximumIterations(kIterations);
    method.setCorrespondenceRandomness(20);
    method.setTransformationEpsilon(1e-3);
    method.setRotationEpsilon(3.5e-4);  // 0.02 degrees
    return aligned(method, target, source, start);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void PEER_ENTRY(const PeerRequest* request,
                                                                  PeerAnswer* answer) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    Eigen::Matrix4f pose = Eigen::Map<const Eigen::Matrix4d>(request->start).cast<float>();
    const auto leaf = static_cast<float>(request->leaf_m);
    answer->iterations = 0;
    const Cloud::Ptr target = cloudOf(request->target);
    const Cloud::Ptr source = cloudOf(request->source);
    switch (request->method) {
        case PeerMethod::ndt:
            pose = ndt(target, thinned(source, kNdtSourceLeaf_m), pose, leaf, answer->iterations);
            break;
        case PeerMethod::ndtThin:
            pose = ndt(target, thinned(source, 0.5F * leaf), pose, leaf, answer->iterations);
            break;
        case PeerMethod::ndtChain: {
            const Cloud::Ptr thin = thinned(source, kNdtSourceLeaf_m);
            float cell = 1;
            for (int level = 0; level < 6; ++level, cell *= 0.8F)
                pose = ndt(target, thin, pose, cell, answer->iterations);
            break;
        }
        case PeerMethod::icp:
            pose = icp(thinned(target, leaf), thinned(source, leaf), pose, answer->iterations);
            break;
        case PeerMethod::gicp:
            pose = gicp(thinned(target, leaf), thinned(source, leaf), pose, kPairDistance_m);
            break;
        case PeerMethod::reference:
            for (const float fine : {1.0F, 0.5F, 0.3F, 0.1F, 0.05F, 0.03F})
                pose = gicp(thinned(target, fine), thinned(source, fine), pose, fine > 0.2F ? 1.0 : 5 * fine);
            break;
        case PeerMethod::planeIcp:
            throw std::runtime_error("PCL is not asked for this method");
    }
    Eigen::Map<Eigen::Matrix4d>(answer->targetFromSource) = pose.cast<double>();
}
