#include "tests/core/registration/global/ParkingLot.h"

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/core/registration/StreetScene.h"

namespace vestige::test {
namespace {

constexpr double kNoise_m = 0.01;

void addPanel(PointCloudBuilder& builder, Random& random, const Eigen::Vector3d& corner,
              const Eigen::Vector3d& u, const Eigen::Vector3d& v, double density) {
    const Eigen::Vector3d normal = u.cross(v).normalized();
    const auto count = static_cast<int>(density * u.cross(v).norm());
    for (int i = 0; i < count; ++i)
        builder.add(corner + random.uniform() * u + random.uniform() * v +
                    random.normal(0, kNoise_m) * normal);
}

void addBox(PointCloudBuilder& builder, Random& random, const Eigen::Vector3d& corner,
            const Eigen::Vector3d& size) {
    const Eigen::Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    constexpr double kDensity = 400;
    addPanel(builder, random, corner, x, z, kDensity);
    addPanel(builder, random, corner + y, x, z, kDensity);
    addPanel(builder, random, corner, y, z, kDensity);
    addPanel(builder, random, corner + x, y, z, kDensity);
    addPanel(builder, random, corner + z, x, y, kDensity);
}

}  // namespace

PointCloud parkingLot(const std::vector<Pose>& cars) {
    Random random(42);
    PointCloudBuilder builder;
    addPanel(builder, random, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, 80);
    addBox(builder, random, {-20, 12, 0}, {40, 0.2, 0.15});
    addBox(builder, random, {-12, -8, 0.1}, {5.2, 2, 2.1});
    addBox(builder, random, {-4, 14, 0}, {12, 0.3, 2.5});
    addBox(builder, random, {1, 2, 0}, {0.8, 0.6, 0.5});
    addBox(builder, random, {12, 8, 0}, {0.3, 0.3, 4});
    addBox(builder, random, {-15, 9, 0}, {0.3, 0.3, 4});
    std::uint64_t seed = 100;
    for (const Pose& car : cars) {
        const PointCloud surface = carSurface(600, kNoise_m, seed++);
        for (std::size_t i = 0; i < surface.size(); ++i) builder.add(car * surface.point(i));
    }
    return std::move(builder).build();
}

PointCloud carFront() {
    const PointCloud surface = carSurface(4000, 0.0005, 7);
    std::vector<std::uint32_t> front;
    for (std::uint32_t i = 0; i < surface.size(); ++i)
        if (surface.point(i).x() > 0) front.push_back(i);
    return surface.select(front);
}

Pose anyPose(std::uint64_t seed) {
    Random random(seed);
    Eigen::Quaterniond turn;
    turn.coeffs() << random.normal(), random.normal(), random.normal(), random.normal();
    Pose pose = Pose::Identity();
    pose.linear() = turn.normalized().toRotationMatrix();
    pose.translation() << random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 30);
    return pose;
}

}  // namespace vestige::test
