#include <pcl/console/print.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>

#include "core/registration/peers/PeerAlignment.h"
#include "core/registration/peers/PeerPoints.h"

namespace vestige {

PeerOutcome alignWithPclIcp(const std::vector<Eigen::Vector3f>& target,
                            const std::vector<Eigen::Vector3f>& source, const Pose& start,
                            const PeerOptions& options) {
    // It warns on stderr of single cells, past every --quiet.
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
    pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
    icp.setMaxCorrespondenceDistance(options.voxel_m);
    icp.setMaximumIterations(options.iterationLimit);
    icp.setTransformationEpsilon(1e-10);  // of the squared step
    icp.setInputSource(cloudOf<pcl::PointCloud<pcl::PointXYZ>>(source));
    icp.setInputTarget(cloudOf<pcl::PointCloud<pcl::PointXYZ>>(target));
    pcl::PointCloud<pcl::PointXYZ> aligned;
    icp.align(aligned, start.matrix().cast<float>());
    using Criteria = pcl::registration::DefaultConvergenceCriteria<float>;
    const auto state = icp.getConvergeCriteria()->getConvergenceState();
    const bool converged = icp.hasConverged() && state != Criteria::CONVERGENCE_CRITERIA_ITERATIONS;
    return {poseOf(icp.getFinalTransformation()), converged, icp.nr_iterations_};
}

}  // namespace vestige
