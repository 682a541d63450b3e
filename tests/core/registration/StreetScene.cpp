#include "tests/core/registration/StreetScene.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige::test {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

struct Box {
    Eigen::Vector3d centre;
    Eigen::Vector3d half;
    double yaw;
};
struct Pole {
    double x, y, radius, height;
};

const std::array kBoxes{Box{{0, 14, 4}, {40, 2, 4}, 0.02},         Box{{-5, -12, 3}, {30, 1.5, 3}, -0.03},
                        Box{{28, 0, 2.5}, {1, 9, 2.5}, 0.1},       Box{{6, 4.5, 0.8}, {2.2, 0.9, 0.8}, 0.05},
                        Box{{-7, 5, 0.75}, {2.1, 0.85, 0.75}, 3},  Box{{13, -5, 0.8}, {2.3, 0.9, 0.8}, -0.2},
                        Box{{-3, -6, 1.2}, {3, 1.1, 1.2}, 0.4},    Box{{-18, 2, 1}, {0.6, 2, 1}, 0.7},
                        Box{{6.3, 4.5, 1.7}, {1, 0.8, 0.25}, 0.05}};
const std::array kPoles{Pole{3, 9, 0.12, 6},  Pole{-10, 9, 0.12, 6}, Pole{16, 9, 0.2, 5},
                        Pole{8, -8, 0.25, 4}, Pole{-14, -7, 0.2, 4}, Pole{20, -7, 0.15, 5}};

double hitBox(const Box& box, const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
    const Eigen::AngleAxisd turn(-box.yaw, Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d start = turn * (from - box.centre);
    const Eigen::Vector3d direction = turn * along;
    double enter = 0, leave = kFar;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (-box.half[axis] - start[axis]) / direction[axis];
        const double b = (box.half[axis] - start[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter < leave && enter > 0 ? enter : kFar;
}

double hitPole(const Pole& pole, const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
    const Eigen::Vector2d start = from.head<2>() - Eigen::Vector2d(pole.x, pole.y);
    const Eigen::Vector2d direction = along.head<2>();
    const double a = direction.squaredNorm(), b = start.dot(direction);
    const double root = b * b - a * (start.squaredNorm() - pole.radius * pole.radius);
    if (root < 0 || a == 0) return kFar;
    const double range = (-b - std::sqrt(root)) / a;
    const double height = from.z() + range * along.z();
    return range > 0 && height < pole.height ? range : kFar;
}

double range(const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
    double nearest = along.z() < 0 ? -from.z() / along.z() : kFar;
    for (const Box& box : kBoxes) nearest = std::min(nearest, hitBox(box, from, along));
    for (const Pole& pole : kPoles) nearest = std::min(nearest, hitPole(pole, from, along));
    return nearest;
}

}  // namespace

PointCloud scanStreet(const Station& station) {
    Random random(station.seed);
    PointCloudBuilder builder;
    for (int ring = 0; ring < station.rings; ++ring)
        for (int step = 0; step < station.perRing; ++step) {
            const double elevation = radians(-30 + 50.0 * (ring + random.uniform() * 0.1) / station.rings);
            const double azimuth = radians(360.0 * step / station.perRing);
            const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                      std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
            const double distance =
                range(station.worldFromScanner.translation(), station.worldFromScanner.linear() * ray);
            if (distance < 60) builder.add((distance + random.normal(0, station.noise_m)) * ray);
        }
    return std::move(builder).build();
}

PointCloud carSurface(double density, double noise_m, std::uint64_t seed) {
    const std::array<Box, 5> body{
        Box{{0, 0, 0.6}, {2.25, 0.9, 0.3}, 0}, Box{{-0.3, 0, 1.15}, {1.1, 0.75, 0.25}, 0},
        Box{{2.2, 0, 0.35}, {0.15, 0.8, 0.12}, 0.1}, Box{{1.4, 0.95, 0.95}, {0.1, 0.15, 0.08}, 0.3},
        Box{{1.4, -0.95, 0.95}, {0.1, 0.15, 0.08}, -0.3}};
    Random random(seed);
    PointCloudBuilder builder;
    for (const Box& box : body)
        for (int side = 0; side < 6; ++side) {
            const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto count = static_cast<int>(density * 4 * box.half[u] * box.half[v]);
            for (int i = 0; i < count; ++i) {
                Eigen::Vector3d point;
                point[axis] = (side % 2 ? 1 : -1) * box.half[axis] + random.normal(0, noise_m);
                point[u] = random.uniform(-box.half[u], box.half[u]);
                point[v] = random.uniform(-box.half[v], box.half[v]);
                builder.add(box.centre + Eigen::AngleAxisd(box.yaw, Eigen::Vector3d::UnitZ()) * point);
            }
        }
    return std::move(builder).build();
}

double turnBetween(const Pose& a, const Pose& b) {
    return degrees(rotationAngle(a.linear().transpose() * b.linear()));
}

double distanceAt(const Pose& a, const Pose& b, const Eigen::Vector3d& point) {
    return (a * point - b * point).norm();
}

}  // namespace vestige::test
