#include <pcl/console/print.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/ndt.h>

#include "core/registration/peers/PeerAlignment.h"
#include "core/registration/peers/PeerPoints.h"

namespace vestige {

PeerOutcome alignWithPclNdt(const std::vector<Eigen::Vector3f>& target,
                            const std::vector<Eigen::Vector3f>& source, const Pose& start,
                            const PeerOptions& options) {
    // It warns on stderr of single cells, past every --quiet.
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    pcl::NormalDistributionsTransform<pcl::PointXYZ, pcl::PointXYZ> ndt;
    ndt.setTransformationEpsilon(1e-4);
    ndt.setStepSize(std::min(0.1, options.voxel_m));
    ndt.setResolution(static_cast<float>(options.voxel_m));
    ndt.setMaximumIterations(options.iterationLimit);
    if (options.outlierRatio) ndt.setOulierRatio(*options.outlierRatio);
    ndt.setInputSource(cloudOf<pcl::PointCloud<pcl::PointXYZ>>(source));
    ndt.setInputTarget(cloudOf<pcl::PointCloud<pcl::PointXYZ>>(target));
    pcl::PointCloud<pcl::PointXYZ> aligned;
    ndt.align(aligned, start.matrix().cast<float>());
    // PCL calls it converged when the iterations run out, too.
    const bool converged = ndt.hasConverged() && ndt.getFinalNumIteration() < options.iterationLimit;
    return {poseOf(ndt.getFinalTransformation()), converged, ndt.getFinalNumIteration()};
}

}  // namespace vestige
