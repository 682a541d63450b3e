#include "core/registration/quality/PoseInformation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/registration/ndt/VoxelGrid.h"

namespace vestige {
namespace {

constexpr double kSigmasPerMad = 1.4826;
constexpr double kBiweight = 4.685;  // 95 % efficient on normal errors

struct Row {
    std::uint64_t cluster;
    Vector6d jacobian;
    double distance;
    double weight;
    Eigen::Vector3d lever;
    const SurfaceCell* plane;
};

double medianOf(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Matrix6d outer(const Vector6d& v) {
    return v * v.transpose();
}

Vector6d jacobianOf(const Eigen::Vector3d& normal, const Eigen::Vector3d& lever, double radius) {
    Vector6d row;
    row << normal, lever.cross(normal) / radius;
    return row;
}

/// What noisy normals add to J J': the variance of the tilt about each axis of the plane.
Matrix6d normalNoise(const Row& row, double radius) {
    const SurfaceCell& plane = *row.plane;
    const double variance = plane.thickness_m * plane.thickness_m / plane.count;
    const Eigen::Vector3d narrow = plane.wide.cross(plane.normal);
    return variance / (plane.wide_m * plane.wide_m) * outer(jacobianOf(plane.wide, row.lever, radius)) +
           variance / (plane.narrow_m * plane.narrow_m) * outer(jacobianOf(narrow, row.lever, radius));
}

/// What a plane's own curvature adds to a distance, of its size.
constexpr double kBendOfSize = 0.001;

double varianceOf(const SurfaceMatch& match, double common) {
    const double bend = kBendOfSize * match.other->size_m;
    return match.predicted_m * match.predicted_m + bend * bend + common;
}

/// The variance that the distances have beyond that, so that their median is right.
double commonVariance(std::span<const SurfaceMatch> matches, double largest) {
    double low = 0;
    double high = largest;
    std::vector<double> ratios(matches.size());
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        ratios.clear();
        for (const SurfaceMatch& match : matches)
            if (match.state == SurfaceState::agrees)
                ratios.push_back(std::abs(match.distance_m) / std::sqrt(varianceOf(match, middle)));
        (kSigmasPerMad * medianOf(ratios) > 1 ? low : high) = middle;
    }
    return high;
}

/// The gradient of an error that all cells of the prevailing orientation share: surfaces that bend one way
/// everywhere, such as a crowned road, sampled differently from two places.
Vector6d sharedBend(const std::vector<Row>& rows) {
    constexpr double kSharedOfSize = 1.5e-4;
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (const Row& row : rows)
        normals += row.weight * row.jacobian.head<3>() * row.jacobian.head<3>().transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
    const Eigen::Vector3d prevailing = solver.eigenvectors().col(2);
    Vector6d gradient = Vector6d::Zero();
    for (const Row& row : rows) {
        const double side = row.jacobian.head<3>().dot(prevailing);
        gradient += (side < 0 ? -1 : 1) * row.weight * kSharedOfSize * row.plane->size_m * row.jacobian;
    }
    return gradient;
}

}  // namespace

bool PoseInformation::holds(const Vector6d& direction) const {
    // Directions that surfaces hold have some hundred times the noise's part, those of a bare plane up to
    // twice.
    constexpr double kOfNoise = 4;
    const double structure = direction.dot(hessian * direction);
    return structure > 0 && structure > kOfNoise * direction.dot(noise * direction);
}

namespace {

/// The directions of the Hessian, what holds each (1 / m^2, the hold of one radius in it), and whether
/// surfaces do. Sums and inverses are taken there: hundreds of square metres beside a millionth lose all
/// digits elsewhere.
struct Directions {
    Matrix6d vectors;
    Vector6d hold;
    Vector6d bySurfaces;  ///< 1 or 0

    explicit Directions(const PoseInformation& information) {
        const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(information.hessian);
        vectors = solver.eigenvectors();
        for (Eigen::Index i = 0; i < 6; ++i) {
            bySurfaces[i] = information.holds(vectors.col(i)) ? 1 : 0;
            hold[i] =
                bySurfaces[i] * solver.eigenvalues()[i] + 1 / (information.radius_m * information.radius_m);
        }
    }
};

}  // namespace

Matrix6d PoseInformation::covariance() const {
    const Directions directions(*this);
    const Matrix6d onto = directions.bySurfaces.asDiagonal();
    const Matrix6d inside = onto * directions.vectors.transpose() * scatter * directions.vectors * onto +
                            Matrix6d::Identity() / (radius_m * radius_m);
    const Matrix6d inverse = directions.hold.cwiseInverse().asDiagonal();
    const Matrix6d covariance =
        directions.vectors * (inverse * inside * inverse) * directions.vectors.transpose();
    return 0.5 * (covariance + covariance.transpose());
}

Vector6d PoseInformation::step() const {
    const Directions directions(*this);
    const Vector6d along = directions.vectors.transpose() * gradient;
    return -directions.vectors * along.cwiseProduct(directions.bySurfaces).cwiseQuotient(directions.hold);
}

PoseInformation poseInformation(std::span<const SurfaceMatch> matches, const std::vector<SurfaceCell>& cells,
                                double cluster_m) {
    PoseInformation info;
    double area = 0;
    double squares = 0;
    for (const SurfaceMatch& match : matches) {
        info.pivot_m += cells[match.cell].area_m2 * match.place;
        area += cells[match.cell].area_m2;
    }
    if (!(area > 0)) return info;
    info.pivot_m /= area;
    std::vector<double> sizes;
    for (const SurfaceMatch& match : matches) {
        squares += cells[match.cell].area_m2 * (match.place - info.pivot_m).squaredNorm();
        if (match.state == SurfaceState::agrees) sizes.push_back(std::abs(match.distance_m));
    }
    if (!(squares > 0)) return info;  // one cell holds no turn
    info.radius_m = std::sqrt(squares / area);
    info.sigma_m = kSigmasPerMad * medianOf(sizes);
    const double common = commonVariance(matches, info.sigma_m * info.sigma_m);
    const VoxelGrid grid(cluster_m);
    std::vector<Row> rows;
    for (const SurfaceMatch& match : matches) {
        if (match.state != SurfaceState::agrees) continue;
        const double variance = varianceOf(match, common);
        const double x = match.distance_m / (kBiweight * std::sqrt(variance));
        if (!(std::abs(x) < 1)) continue;
        Row row;
        const Eigen::Vector3d& place = match.place;
        row.cluster = grid.key(place.x(), place.y(), place.z());
        row.lever = place - info.pivot_m;
        row.jacobian = jacobianOf(match.other->normal, row.lever, info.radius_m);
        row.distance = match.distance_m;
        row.weight = (1 - x * x) * (1 - x * x) / variance;
        row.plane = match.other;
        rows.push_back(row);
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return a.cluster < b.cluster; });
    Matrix6d full = Matrix6d::Zero();
    for (const Row& row : rows) {
        full += row.weight * outer(row.jacobian);
        info.noise += row.weight * normalNoise(row, info.radius_m);
        info.weight += row.weight;
    }
    info.hessian = full - info.noise;
    const Matrix6d ridge = 1e-9 * info.weight * Matrix6d::Identity();
    for (std::size_t begin = 0; begin < rows.size();) {
        std::size_t end = begin;
        Vector6d gradient = Vector6d::Zero();
        Matrix6d part = Matrix6d::Zero();
        for (; end < rows.size() && rows[end].cluster == rows[begin].cluster; ++end) {
            gradient += rows[end].weight * rows[end].distance * rows[end].jacobian;
            part += rows[end].weight * outer(rows[end].jacobian);
        }
        info.gradient += gradient;
        // (I - part full^-1)^-1 gradient
        const Matrix6d without = full + ridge - part;
        const Vector6d madeUp = (full + ridge) * without.ldlt().solve(gradient);
        info.scatter += outer(madeUp);
        ++info.clusters;
        begin = end;
    }
    const Vector6d shared = sharedBend(rows);
    info.scatter += outer(shared);
    return info;
}

}  // namespace vestige
