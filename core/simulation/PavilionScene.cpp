#include "core/simulation/PavilionScene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/Units.h"

namespace vestige {
namespace {

constexpr std::uint64_t kSceneStream = 500;
constexpr std::uint64_t kWalkStream = 501;
constexpr std::size_t kWholeWalk = 32;

Eigen::Vector2d onPath(double x) {
    return {x, 1.6 * std::sin(2 * std::numbers::pi * x / 14)};
}

/// The x at which the path from `from` has gone `length_m`.
double along(double from, double length_m) {
    constexpr double kStep_m = 0.001;
    double x = from;
    for (double gone = 0; gone < length_m; x += kStep_m) gone += (onPath(x + kStep_m) - onPath(x)).norm();
    return x;
}

}  // namespace

SurfaceModel pavilionScene(std::uint64_t seed) {
    Random random(seed, kSceneStream);
    ModelBuilder builder;
    addPark(builder, random);
    addPavilion(builder, random);
    return builder.take();
}

void addLeaves(ModelBuilder& builder, const Eigen::Vector3d& centre, const Eigen::Vector3d& halfSize,
               int count, double leaf_m, bool ellipsoid, Random& random) {
    const auto within = [&]() -> Eigen::Vector3d {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        return {x, y, z};
    };
    const auto inBall = [&] {
        Eigen::Vector3d at = within();
        while (at.squaredNorm() > 1 || at.squaredNorm() < 1e-4) at = within();
        return at;
    };
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d at = centre + (ellipsoid ? inBall() : within()).cwiseProduct(halfSize);
        const Eigen::Vector3d right = 0.5 * leaf_m * inBall().normalized();
        const Eigen::Vector3d up = 0.5 * leaf_m * right.cross(inBall()).normalized();
        builder.quad(at - right - up, at + right - up, at + right + up, at - right + up);
    }
}

double pavilionGround(double x, double y) {
    // Level up to a metre from the paving, then rolling by some decimetres.
    const double outside = std::hypot(std::max(0.0, std::abs(x) - 6.0), std::max(0.0, std::abs(y) - 4.5));
    const double share = std::min(1.0, outside / 6);
    return share * (0.35 * std::sin(0.31 * x + 0.5) * std::cos(0.23 * y) - 0.1);
}

std::vector<Pose> pavilionWalk(std::size_t count, std::uint64_t seed) {
    constexpr double kHeight_m = 1.05;
    constexpr double kStride_m = 0.58;
    std::vector<Pose> stops;
    double x = -8;
    // However many stops are asked for, they lie in the middle of the same walk, a stride apart.
    if (count < kWholeWalk) x = along(x, kStride_m * 0.5 * static_cast<double>(kWholeWalk - count));
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, kWalkStream + (i << 8));
        const Eigen::Vector2d at = onPath(x);
        const Eigen::Vector2d ahead = onPath(x + 0.05) - onPath(x - 0.05);
        const double heading = std::atan2(ahead.y(), ahead.x()) + random.normal(0, radians(2.0));
        const double pitch = random.normal(0, radians(1.0));
        const double roll = random.normal(0, radians(1.0));
        Pose pose = Pose::Identity();
        pose.translation() << at.x() + random.normal(0, 0.03), at.y() + random.normal(0, 0.03),
            pavilionGround(at.x(), at.y()) + kHeight_m + random.normal(0, 0.015);
        pose.linear() = (Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) *
                         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                            .toRotationMatrix();
        stops.push_back(pose);
        x = along(x, kStride_m);
    }
    return stops;
}

}  // namespace vestige
