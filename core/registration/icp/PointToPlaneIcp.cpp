#include "core/registration/icp/PointToPlaneIcp.h"

#include <Eigen/Cholesky>

#include "core/base/Parallel.h"
#include "core/registration/Descent.h"
#include "core/registration/OverlapQuality.h"
#include "core/registration/SourceLevels.h"
#include "core/registration/icp/SurfaceNormals.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 512;
constexpr std::size_t kNormalPoints = 10;
/// Keeps directions that no plane holds where they are.
constexpr double kDamping = 1e-6;

struct PairSums {
    std::size_t pairs = 0;
    double squares = 0;
    Vector6d gradient = Vector6d::Zero();
    Matrix6d hessian = Matrix6d::Zero();

    PairSums& operator+=(const PairSums& other) {
        pairs += other.pairs;
        squares += other.squares;
        gradient += other.gradient;
        hessian += other.hessian;
        return *this;
    }
};

/// The thinned target with its planes.
class PlaneTarget {
  public:
    explicit PlaneTarget(std::vector<Eigen::Vector3f> points)
        : points_(std::move(points)),
          index_(points_),
          normals_(surfaceNormals(index_, points_, kNormalPoints)) {}

    /// Mean squared distance of the pairs and its Gauss-Newton derivatives by (t, r w).
    ScoredPose operator()(const CentredSource& source, const Pose& pose, double reach) const {
        const auto squaredReach = static_cast<float>(reach * reach);
        const PairSums sums =
            parallelSum(source.points.size(), kGrain, PairSums{}, [&](std::size_t begin, std::size_t end) {
                PairSums part;
                for (std::size_t i = begin; i < end; ++i) add(part, source, pose, i, squaredReach);
                return part;
            });
        ScoredPose scored;
        scored.inside = sums.pairs;
        if (sums.pairs == 0) return scored;
        const double share = 1 / static_cast<double>(sums.pairs);
        scored.score = share * sums.squares;
        scored.gradient = 2 * share * sums.gradient;
        scored.hessian = 2 * share * sums.hessian;
        return scored;
    }

  private:
    void add(PairSums& sums, const CentredSource& source, const Pose& pose, std::size_t i,
             float squaredReach) const {
        const Eigen::Vector3d turned = pose.linear() * source.points[i].cast<double>();
        const Eigen::Vector3d x = turned + pose.translation();
        const auto pair = index_.closest(x.cast<float>(), squaredReach);
        if (!pair) return;
        const Eigen::Vector3d normal = normals_[pair->point].cast<double>();
        const double distance = normal.dot(x - points_[pair->point].cast<double>());
        Vector6d row;
        row << normal, turned.cross(normal) / source.radius;
        ++sums.pairs;
        sums.squares += distance * distance;
        sums.gradient += distance * row;
        sums.hessian += row * row.transpose();
    }

    std::vector<Eigen::Vector3f> points_;
    NeighbourIndex index_;
    std::vector<Eigen::Vector3f> normals_;
};

}  // namespace

Result<RegistrationResult> pointToPlaneIcp(const RegistrationFrame& frame, const Similarity& initial,
                                           const IcpOptions& options, const JobControl& control,
                                           const RegistrationWatch& watch) {
    const double leaf = options.leaf_m.value_or(options.reach_m / 8);
    if (Status status = checkTarget(frame, leaf); !status) return fail(status.error());
    const CentredSource source = SourceLevels(frame, leaf).at(0);
    if (Status status = checkSource(source); !status) return fail(status.error());
    if (control.cancelled()) return fail(cancelledError());
    std::vector<Eigen::Vector3f> thinned;
    for (const CellMoments& cell : gatherPoints(frame.target(), VoxelGrid(leaf)))
        thinned.emplace_back(cell.mean[0], cell.mean[1], cell.mean[2]);
    const PlaneTarget target(std::move(thinned));
    control.progress(0.3, "registration");

    Descent descent(frame, initial, watch, 1);
    const TrustRegionWatch observe = descent.observer(source, options.reach_m);
    TrustRegionOutcome outcome{descent.local(source), {}, 0, StopReason::iterationLimit};
    outcome.scored = target(source, outcome.pose, options.reach_m);
    if (observe) observe(outcome, {options.reach_m, 0, true});
    while (outcome.iterations < options.iterationLimit) {
        if (control.cancelled()) return fail(cancelledError());
        if (outcome.scored.inside < kFewestPoints) {
            outcome.stop = StopReason::noOverlap;
            break;
        }
        const Vector6d step =
            -(outcome.scored.hessian + kDamping * Matrix6d::Identity()).ldlt().solve(outcome.scored.gradient);
        outcome.pose = NdtScore::moved(outcome.pose, step, source.radius);
        outcome.scored = target(source, outcome.pose, options.reach_m);
        ++outcome.iterations;
        if (observe) observe(outcome, {options.reach_m, step.norm(), true});
        if (step.norm() < options.stepLimit_m) {
            outcome.stop = StopReason::step;
            break;
        }
    }
    descent.record(outcome, source, options.reach_m);
    RegistrationResult& result = descent.result();
    result.inlierDistance_m = options.reach_m / 2 + 3 * options.rangeNoise_m;
    const VoxelGrid grid(options.reach_m / 2);
    const std::vector<NormalDistributions> surfaces{
        NormalDistributions(gatherPoints(frame.target(), grid), grid, {})};
    setOverlap(result, surfaces, source, descent.local(source));
    return std::move(result);
}

}  // namespace vestige
