#include "core/registration/quality/SurfaceFit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

constexpr int kLevels = 5;
constexpr double kCellsPerRadius = 100;
constexpr double kClusterCells = 8;
constexpr double kToleranceOfCell = 0.3;
constexpr std::size_t kSome = 1500;
constexpr std::size_t kFew = 500;

/// Edge of the finest cells: a share of the source's radius, but wide enough to be flat under the target's
/// noise, which is taken from the flattest quarter of its largest cells.
double finestCell(const std::vector<Eigen::Vector3f>& target, double radius_m) {
    constexpr double kNoises = 6;
    const double finest = radius_m / kCellsPerRadius;
    return std::max(finest, kNoises * flattestQuarter(target, finest * (1 << (kLevels - 1))));
}

std::vector<SurfaceCell> thinned(const std::vector<SurfaceCell>& cells, std::size_t most) {
    std::vector<SurfaceCell> some;
    for (std::size_t i = 0; i < cells.size(); i += cells.size() / most + 1) some.push_back(cells[i]);
    return some;
}

double medianThickness(const std::vector<SurfaceCell>& cells) {
    if (cells.empty()) return 0;
    std::vector<double> values;
    for (const SurfaceCell& cell : cells) values.push_back(cell.thickness_m);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The least share v'part v / v'whole v over all v; directions that `whole` hardly holds do not count.
double leastShare(const Matrix6d& part, const Matrix6d& whole) {
    constexpr double kFloor = 0.003;
    const double trace = whole.trace();
    if (!(trace > 0)) return 0;
    const Matrix6d floor = kFloor * trace * Matrix6d::Identity();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> solver(part + floor, whole + floor,
                                                                    Eigen::EigenvaluesOnly);
    return std::clamp(solver.eigenvalues()[0], 0.0, 1.0);
}

SurfaceShares sharesOf(const std::vector<SurfaceMatch>& matches, const std::vector<SurfaceCell>& cells) {
    SurfaceShares shares;
    Eigen::Vector3d pivot = Eigen::Vector3d::Zero();
    double area = 0, squares = 0;
    for (const SurfaceMatch& match : matches) {
        if (match.state == SurfaceState::vague) continue;
        pivot += cells[match.cell].area_m2 * match.place;
        area += cells[match.cell].area_m2;
    }
    if (!(area > 0)) return shares;
    pivot /= area;
    for (const SurfaceMatch& match : matches)
        if (match.state != SurfaceState::vague)
            squares += cells[match.cell].area_m2 * (match.place - pivot).squaredNorm();
    const double radius = std::sqrt(squares / area);
    if (!(radius > 0)) return shares;
    Matrix6d agreeing = Matrix6d::Zero(), seen = Matrix6d::Zero(), all = Matrix6d::Zero();
    for (const SurfaceMatch& match : matches) {
        if (match.state == SurfaceState::vague) continue;
        const double weight = cells[match.cell].area_m2;
        const Eigen::Vector3d lever = match.place - pivot;
        Vector6d row;
        row << match.normal, lever.cross(match.normal) / radius;
        const Matrix6d square = weight * row * row.transpose();
        all += square;
        if (match.state != SurfaceState::unseen) seen += square;
        if (match.state == SurfaceState::agrees) agreeing += square;
        (match.state == SurfaceState::agrees      ? shares.agrees
         : match.state == SurfaceState::conflicts ? shares.conflicts
                                                  : shares.unseen) += weight / area;
    }
    shares.support = leastShare(agreeing, all);
    shares.seenSupport = leastShare(agreeing, seen);
    return shares;
}

}  // namespace

SurfaceFit::SurfaceFit(const std::vector<Eigen::Vector3f>& target, const std::vector<Eigen::Vector3f>& source,
                       double radius_m)
    : finest_m_(finestCell(target, radius_m)),
      target_(surfaceCells(target, finest_m_, kLevels), finest_m_, kLevels),
      source_(surfaceCells(source, finest_m_, kLevels), finest_m_, kLevels),
      tolerance_m_(std::max(kToleranceOfCell * finest_m_, medianThickness(target_.cells()))),
      cluster_m_(kClusterCells * finest_m_),
      some_(thinned(source_.cells(), kSome)),
      few_(thinned(source_.cells(), kFew)) {}

std::vector<SurfaceMatch> SurfaceFit::matches(const Pose& pose) const {
    return matchSurfaces(source_.cells(), pose, target_, tolerance_m_);
}

SurfaceShares SurfaceFit::sourceShares(const Pose& pose) const {
    return sharesOf(matches(pose), source_.cells());
}

SurfaceShares SurfaceFit::targetShares(const Pose& pose) const {
    return sharesOf(matchSurfaces(target_.cells(), pose.inverse(), source_, tolerance_m_), target_.cells());
}

double SurfaceFit::quickAgreement(const Pose& pose) const {
    double area = 0, agrees = 0;
    for (const SurfaceMatch& match : matchSurfaces(few_, pose, target_, tolerance_m_)) {
        area += few_[match.cell].area_m2;
        if (match.state == SurfaceState::agrees) agrees += few_[match.cell].area_m2;
    }
    return area > 0 ? agrees / area : 0;
}

Eigen::Vector3d SurfaceFit::middle(const Pose& pose) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0;
    for (const SurfaceCell& cell : target_.cells()) {
        sum += cell.area_m2 * cell.mean;
        area += cell.area_m2;
    }
    for (const SurfaceCell& cell : source_.cells()) {
        sum += cell.area_m2 * (pose * cell.mean);
        area += cell.area_m2;
    }
    return area > 0 ? Eigen::Vector3d(sum / area) : pose.translation();
}

PoseInformation SurfaceFit::information(const Pose& pose) const {
    return poseInformation(matches(pose), source_.cells(), cluster_m_);
}

Pose SurfaceFit::steppedTo(Pose pose, const std::vector<SurfaceCell>& cells, double tolerance_m,
                           int steps) const {
    for (int i = 0; i < steps; ++i) {
        const PoseInformation info =
            poseInformation(matchSurfaces(cells, pose, target_, tolerance_m), cells, cluster_m_);
        if (!(info.weight > 0)) break;
        pose = stepped(pose, info.step(), info.pivot_m, info.radius_m);
    }
    return pose;
}

Pose SurfaceFit::refined(const Pose& pose) const {
    return steppedTo(pose, source_.cells(), tolerance_m_, 3);
}

Pose SurfaceFit::drawnIn(const Pose& pose) const {
    constexpr double kWide = 4;
    return steppedTo(steppedTo(pose, some_, kWide * tolerance_m_, 3), some_, tolerance_m_, 2);
}

Vector6d stepBetween(const Pose& a, const Pose& b, const Eigen::Vector3d& pivot, double radius_m) {
    const Pose move = b * a.inverse();
    const Eigen::AngleAxisd turn(move.linear());
    Vector6d step;
    step << move * pivot - pivot, radius_m * turn.angle() * turn.axis();
    return step;
}

Pose stepped(const Pose& pose, const Vector6d& step, const Eigen::Vector3d& pivot, double radius_m) {
    const Eigen::Vector3d turn = step.tail<3>() / radius_m;
    const double angle = turn.norm();
    Pose move = Pose::Identity();
    if (angle > 0) move.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    move.translation() = pivot + step.head<3>() - move.linear() * pivot;
    return move * pose;
}

}  // namespace vestige
