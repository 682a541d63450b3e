#include "core/registration/RegistrationFrame.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 16384;

/// The points of a cloud, or those of some `indices`, scaled, round `origin`.
std::vector<Eigen::Vector3f> offsetsFrom(const PointCloud& cloud, double scale, const Eigen::Vector3d& origin,
                                         const std::vector<std::uint32_t>* indices = nullptr) {
    std::vector<Eigen::Vector3f> offsets(indices != nullptr ? indices->size() : cloud.size());
    const std::span<const Eigen::Vector3f> from = cloud.offsets();
    const bool exact = cloud.residuals().empty();
    const Eigen::Vector3d base = cloud.origin();
    parallelFor(offsets.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t place = indices != nullptr ? (*indices)[i] : i;
            Eigen::Vector3d point = base + from[place].cast<double>();
            if (!exact) point += cloud.residuals()[place].cast<double>();
            offsets[i] = (scale * point - origin).cast<float>();
        }
    });
    return offsets;
}

/// The points inside a box, in order, and the box that they fill.
struct PointsWithin {
    std::vector<std::uint32_t> indices;
    BoundingBox bounds;
};
PointsWithin pointsWithin(const PointCloud& cloud, const BoundingBox& box) {
    std::vector<PointsWithin> parts((cloud.size() + kGrain - 1) / kGrain);
    parallelChunks(cloud.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d point = cloud.point(i);
            if ((point.array() < box.min.array()).any() || (point.array() > box.max.array()).any()) continue;
            parts[chunk].indices.push_back(static_cast<std::uint32_t>(i));
            parts[chunk].bounds.add(point);
        }
    });
    PointsWithin all;
    for (const PointsWithin& part : parts) {
        all.indices.insert(all.indices.end(), part.indices.begin(), part.indices.end());
        all.bounds.add(part.bounds);
    }
    return all;
}

Eigen::Vector3d centroidOf(std::span<const Eigen::Vector3f> points) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& point : points) sum += point.cast<double>();
    return points.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(points.size()));
}

/// From the origin.
double rmsDistance(std::span<const Eigen::Vector3f> points) {
    double sum = 0;
    for (const Eigen::Vector3f& point : points) sum += point.cast<double>().squaredNorm();
    return points.empty() ? 0 : std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace

RegistrationFrame::RegistrationFrame(const PointCloud& target, const PointCloud& source,
                                     const Similarity& initial, double margin_m) {
    sourceOrigin_ = initial.scale * source.bounds().centre();
    source_ = offsetsFrom(source, initial.scale, sourceOrigin_);
    BoundingBox reach = source.bounds().transformed(initial);
    reach.min.array() -= margin_m;
    reach.max.array() += margin_m;
    const BoundingBox& all = target.bounds();
    if ((all.min.array() >= reach.min.array()).all() && (all.max.array() <= reach.max.array()).all()) {
        targetOrigin_ = all.centre();
        target_ = offsetsFrom(target, 1, targetOrigin_);
        return;
    }
    const PointsWithin within = pointsWithin(target, reach);
    targetOrigin_ = within.indices.empty() ? reach.centre() : within.bounds.centre();
    target_ = offsetsFrom(target, 1, targetOrigin_, &within.indices);
}

double RegistrationFrame::extent_m() const {
    float most = 0;
    for (const auto* points : {&target_, &source_})
        for (const Eigen::Vector3f& point : *points) most = std::max(most, point.lpNorm<Eigen::Infinity>());
    return static_cast<double>(most);
}

CentredSource RegistrationFrame::centred(std::vector<Eigen::Vector3f> points) const {
    CentredSource thinned;
    thinned.points = std::move(points);
    const Eigen::Vector3d centroid = centroidOf(thinned.points);
    thinned.centre = sourceOrigin_ + centroid;
    for (Eigen::Vector3f& point : thinned.points) point = (point.cast<double>() - centroid).cast<float>();
    thinned.radius = rmsDistance(thinned.points);
    return thinned;
}

Pose RegistrationFrame::toLocal(const Pose& targetFromSource, const CentredSource& source) const {
    Pose local = targetFromSource;
    local.translation() = targetFromSource * source.centre - targetOrigin_;
    return local;
}

Pose RegistrationFrame::toWorld(const Pose& localFromCentred, const CentredSource& source) const {
    Pose world = Pose::Identity();
    world.linear() = nearestRotation(localFromCentred.linear());
    world.translation() = localFromCentred.translation() + targetOrigin_ - world.linear() * source.centre;
    return world;
}

double surfaceRadius(const PointCloud& cloud) {
    constexpr std::size_t kSample = 65536;
    constexpr int kCells = 64;
    const double diagonal = cloud.bounds().diagonal();
    if (!(diagonal > 0)) return 0;
    // Cells that a sample of the points touches stand for the surface, each by its centre: the square root of
    // the mean square moves by less than a hundredth.
    const double perCell = kCells / diagonal;
    const Eigen::Vector3d corner = cloud.bounds().min;
    std::vector<char> touched(std::size_t{kCells} * kCells * kCells, 0);
    const std::size_t step = std::max<std::size_t>(1, cloud.size() / kSample);
    double count = 0, squares = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < cloud.size(); i += step) {
        const Eigen::Vector3i cell = ((cloud.point(i) - corner) * perCell).cast<int>().cwiseMin(kCells - 1);
        char& there = touched[static_cast<std::size_t>((cell.z() * kCells + cell.y()) * kCells + cell.x())];
        if (there != 0) continue;
        there = 1;
        const Eigen::Vector3d centre = cell.cast<double>() / perCell;
        count += 1;
        sum += centre;
        squares += centre.squaredNorm();
    }
    return std::sqrt(std::max(0.0, squares / count - (sum / count).squaredNorm()));
}

}  // namespace vestige
