#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "core/registration/global/FeatureMatches.h"

namespace vestige {

/// A pose that several matches agree on.
struct PoseProposal {
    Eigen::Isometry3d targetFromSource = Eigen::Isometry3d::Identity();  ///< between the surfels' frames
    std::uint32_t support = 0;                                           ///< matches that it explains
};

struct ConsistencyOptions {
    double tolerance_m = 0;      ///< of the distance of two matches' points
    double leastDistance_m = 0;  ///< two matches nearer to one another tell nothing of the pose
    std::size_t proposals = 200;
};

/// Proposals from matches that agree with each other in distance and in their normals' angles, by
/// second-order spatial compatibility: how many matches agree with both of two (Chen, Sun, Yang, Tao 2022,
/// SC2-PCR). The match with the most agreeing ones seeds the first proposal; what a proposal explains seeds
/// no other. In the order they were found.
std::vector<PoseProposal> consistentPoses(const Surfels& target, const Surfels& source,
                                          std::span<const SurfelMatch> matches,
                                          const ConsistencyOptions& options);

/// The rotation and shift that lay the weighted points `from` on `to` with least squares.
class WeightedAlignment {
  public:
    void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double weight = 1);
    Eigen::Isometry3d pose() const;

  private:
    double weight_ = 0;
    Eigen::Vector3d from_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3d products_ = Eigen::Matrix3d::Zero();
};

}  // namespace vestige
