#include "core/registration/ndt/NdtScore.h"

#include <array>
#include <bit>
#include <cstdint>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 1024;

/// Sums of one chunk; the Hessian's upper triangle row by row.
struct Sums {
    double score = 0;
    std::size_t inside = 0;
    std::array<double, 6> gradient{};
    std::array<double, 21> hessian{};

    Sums& operator+=(const Sums& other) {
        score += other.score;
        inside += other.inside;
        for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] += other.gradient[i];
        for (std::size_t i = 0; i < hessian.size(); ++i) hessian[i] += other.hessian[i];
        return *this;
    }
};

/// Exponents below this leave nothing of a point's score.
constexpr double kSmallestExponent = -40;

/// e^x for kSmallestExponent <= x <= 0, to 1e-15; the same bits on every processor, unlike the C library's.
double exponential(double x) {
    constexpr double kLog2E = 1.4426950408889634074, kLn2High = 6.93147180369123816490e-01,
                     kLn2Low = 1.90821492927058770002e-10;
    const auto power = static_cast<std::int64_t>(x * kLog2E - 0.5);
    const auto whole = static_cast<double>(power);
    const double r = (x - whole * kLn2High) - whole * kLn2Low;
    constexpr std::array kInverseFactorials{
        1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
        1.0 / 120,       1.0 / 24,       1.0 / 6,       1.0 / 2,      1.0,         1.0};
    double sum = 0;
    for (const double coefficient : kInverseFactorials) sum = sum * r + coefficient;
    return sum * std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52);
}

/// Adds one point: `x` in the target's frame, `y` = R times the centred source point, over the radius.
///
/// With e = x - mean, u = C^-1 e, q = e.u and J = [I | -[y]x] the derivatives of s = d1 exp(-d2 q / 2) are
/// -d2 s J'u and k (J' C^-1 J + D - d2 J'u u'J), k = -d2 s, where D, the second derivative of exp(w) y
/// against u, is ((u y' + y u') / 2 - (u.y) I) / radius in the block of the rotation.
void addPoint(Sums& sums, const NormalCell& cell, const Eigen::Vector3d& x, const Eigen::Vector3d& y,
              double perRadius) {
    const double ex = x.x() - cell.mean[0];
    const double ey = x.y() - cell.mean[1];
    const double ez = x.z() - cell.mean[2];
    const double axx = cell.information[0], axy = cell.information[1], axz = cell.information[2];
    const double ayy = cell.information[3], ayz = cell.information[4], azz = cell.information[5];
    const double ux = axx * ex + axy * ey + axz * ez;
    const double uy = axy * ex + ayy * ey + ayz * ez;
    const double uz = axz * ex + ayz * ey + azz * ez;
    const double q = ex * ux + ey * uy + ez * uz;
    const double d2 = cell.steepness;
    ++sums.inside;
    const double exponent = -0.5 * d2 * q;
    if (!(exponent >= kSmallestExponent)) return;
    const double s = cell.depth * exponential(exponent);
    sums.score += s;

    const double k = -d2 * s;
    const double yx = y.x(), yy = y.y(), yz = y.z();
    const double a[6] = {ux, uy, uz, yy * uz - yz * uy, yz * ux - yx * uz, yx * uy - yy * ux};
    for (std::size_t i = 0; i < 6; ++i) sums.gradient[i] += k * a[i];

    // M = C^-1 (-[y]x), rows of the translation, columns of the rotation.
    const double m00 = axz * yy - axy * yz, m01 = axx * yz - axz * yx, m02 = axy * yx - axx * yy;
    const double m10 = ayz * yy - ayy * yz, m11 = axy * yz - ayz * yx, m12 = ayy * yx - axy * yy;
    const double m20 = azz * yy - ayz * yz, m21 = axz * yz - azz * yx, m22 = ayz * yx - axz * yy;
    // [y]x M, its upper triangle, plus D.
    const double dot = (ux * yx + uy * yy + uz * yz) * perRadius;
    const double half = 0.5 * perRadius;
    const double r00 = yy * m20 - yz * m10 + 2 * half * ux * yx - dot;
    const double r01 = yy * m21 - yz * m11 + half * (ux * yy + uy * yx);
    const double r02 = yy * m22 - yz * m12 + half * (ux * yz + uz * yx);
    const double r11 = yz * m01 - yx * m21 + 2 * half * uy * yy - dot;
    const double r12 = yz * m02 - yx * m22 + half * (uy * yz + uz * yy);
    const double r22 = yx * m12 - yy * m02 + 2 * half * uz * yz - dot;
    const double base[21] = {axx, axy, axz, m00, m01, m02, ayy, ayz, m10, m11, m12,
                             azz, m20, m21, m22, r00, r01, r02, r11, r12, r22};
    std::size_t entry = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const double di = d2 * a[i];
        for (std::size_t j = i; j < 6; ++j, ++entry) sums.hessian[entry] += k * (base[entry] - di * a[j]);
    }
}

const NormalCell* smallestCell(std::span<const NormalDistributions* const> target, const Eigen::Vector3d& x) {
    for (const NormalDistributions* level : target)
        if (const NormalCell* cell = level->find(x.x(), x.y(), x.z())) return cell;
    return nullptr;
}

}  // namespace

NdtScore::NdtScore(std::span<const NormalDistributions> target, const CentredSource& source)
    : source_(source) {
    for (std::size_t level = target.size(); level-- > 0;) target_.push_back(&target[level]);
}

NdtScore NdtScore::withFinest(const NormalDistributions& finest) const {
    NdtScore other = *this;
    other.target_.front() = &finest;
    return other;
}

ScoredPose NdtScore::operator()(const Pose& pose) const {
    const double perRadius = 1 / source_.radius;
    const Eigen::Matrix3d rotation = pose.linear();
    const Eigen::Vector3d translation = pose.translation();
    const std::size_t count = source_.points.size();
    const Sums sums = parallelSum(count, kGrain, Sums{}, [&](std::size_t begin, std::size_t end) {
        Sums part;
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d turned = rotation * source_.points[i].cast<double>();
            const Eigen::Vector3d x = turned + translation;
            if (const NormalCell* cell = smallestCell(target_, x))
                addPoint(part, *cell, x, turned * perRadius, perRadius);
        }
        return part;
    });
    ScoredPose scored;
    const double perPoint = 1 / static_cast<double>(count);
    scored.score = sums.score * perPoint;
    scored.inside = sums.inside;
    std::size_t entry = 0;
    for (int i = 0; i < 6; ++i) {
        scored.gradient[i] = sums.gradient[static_cast<std::size_t>(i)] * perPoint;
        for (int j = i; j < 6; ++j, ++entry)
            scored.hessian(i, j) = scored.hessian(j, i) = sums.hessian[entry] * perPoint;
    }
    return scored;
}

Pose NdtScore::moved(const Pose& pose, const Vector6d& step, double radius) {
    // The quaternion (1, w/2) turns by |w| up to third order and needs no sine that differs between machines.
    const Eigen::Vector3d half = step.tail<3>() / (2 * radius);
    Pose result = pose;
    result.translation() += step.head<3>();
    result.linear() =
        Eigen::Quaterniond(1, half.x(), half.y(), half.z()).normalized().toRotationMatrix() * pose.linear();
    return result;
}

}  // namespace vestige
