#include "core/geometry/PointCloud.h"

#include <algorithm>
#include <utility>

#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/geometry/Selected.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 16384;

}  // namespace

PointAttributes PointAttributes::select(std::span<const std::uint32_t> indices) const {
    PointAttributes chosen;
    chosen.intensity = intensity.select(indices);
    chosen.color = selected(color, indices);
    chosen.classification = selected(classification, indices);
    chosen.gpsTime = selected(gpsTime, indices);
    chosen.normal = selected(normal, indices);
    chosen.pointSource = selected(pointSource, indices);
    chosen.returnNumber = selected(returnNumber, indices);
    chosen.returnCount = selected(returnCount, indices);
    return chosen;
}

PointCloud::PointCloud(Eigen::Vector3d origin, LargeArray<Eigen::Vector3f> offsets,
                       LargeArray<Eigen::Vector3f> residuals, PointAttributes attributes)
    : origin_(std::move(origin)),
      offsets_(std::move(offsets)),
      residuals_(std::move(residuals)),
      attributes_(std::move(attributes)) {
    findBounds();
}

PointCloud::PointCloud(Eigen::Vector3d origin, LargeArray<Eigen::Vector3f> offsets,
                       const CoordinateGrid& grid, const BoundingBox& bounds, PointAttributes attributes)
    : origin_(std::move(origin)),
      offsets_(std::move(offsets)),
      grid_(grid),
      attributes_(std::move(attributes)),
      bounds_(bounds) {}

void PointCloud::findBounds() {
    std::vector<BoundingBox> parts((size() + kGrain - 1) / kGrain);
    parallelChunks(size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        // A point's coordinates grow with its offset's, so that without residuals the offsets' bounds do.
        if (residuals_.empty()) {
            // Eight points at a time fill whole registers; lane k holds the axis k % 3.
            constexpr std::size_t kLanes = 8;
            using Lanes = Eigen::Array<float, 3 * kLanes, 1>;
            Eigen::Vector3f least = offsets_[begin];
            Eigen::Vector3f most = least;
            Lanes low = least.replicate<kLanes, 1>().array();
            Lanes high = low;
            std::size_t i = begin;
            for (; i + kLanes <= end; i += kLanes) {
                const Lanes eight = Eigen::Map<const Lanes>(offsets_[i].data());
                low = low.min(eight);
                high = high.max(eight);
            }
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const auto at = static_cast<Eigen::Index>(3 * lane);
                least = least.cwiseMin(low.segment<3>(at).matrix());
                most = most.cwiseMax(high.segment<3>(at).matrix());
            }
            for (; i < end; ++i) {
                least = least.cwiseMin(offsets_[i]);
                most = most.cwiseMax(offsets_[i]);
            }
            for (const Eigen::Vector3f& corner : {least, most}) {
                const Eigen::Vector3d world = origin_ + corner.cast<double>();
                parts[chunk].add(grid_ ? grid_->snapped(world) : world);
            }
        } else {
            for (std::size_t i = begin; i < end; ++i) parts[chunk].add(point(i));
        }
    });
    for (const BoundingBox& part : parts) bounds_.add(part);
}

PointCloud PointCloud::select(std::span<const std::uint32_t> indices) const {
    PointCloud chosen;
    chosen.origin_ = origin_;
    chosen.offsets_ = selected(offsets_, indices);
    chosen.residuals_ = selected(residuals_, indices);
    chosen.grid_ = grid_;
    chosen.attributes_ = attributes_.select(indices);
    chosen.findBounds();
    return chosen;
}

PointCloud PointCloud::transformed(const Similarity& toFromHere) const& {
    return PointCloud(*this).transformed(toFromHere);
}

PointCloud PointCloud::transformed(const Similarity& toFromHere) && {
    if (toFromHere.isIdentity()) return std::move(*this);
    const Eigen::Vector3d origin = toFromHere * origin_;
    const BoundingBox box = bounds_.transformed(toFromHere);
    // As PointCloudBuilder has it. The box is no smaller than the points; it may be off by its rounding.
    const double reach =
        empty() ? 0 : (box.min - origin).cwiseAbs().cwiseMax((box.max - origin).cwiseAbs()).maxCoeff();
    const bool mayBeFar = !(reach < 0.999 * static_cast<double>(PointCloudBuilder::kExactRange));
    if (mayBeFar && residuals_.empty()) residuals_.resize(size(), Eigen::Vector3f::Zero());
    const Eigen::Matrix3f rotation = toFromHere.pose.linear().cast<float>();
    parallelFor(size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d offset = toFromHere * point(i) - origin;
            offsets_[i] = offset.cast<float>();
            if (!residuals_.empty()) residuals_[i] = (offset - offsets_[i].cast<double>()).cast<float>();
            if (!attributes_.normal.empty()) attributes_.normal[i] = rotation * attributes_.normal[i];
        }
    });
    const bool far = mayBeFar && std::any_of(offsets_.begin(), offsets_.end(), [](const auto& offset) {
                         return offset.cwiseAbs().maxCoeff() > PointCloudBuilder::kExactRange;
                     });
    if (!far) residuals_ = {};
    origin_ = origin;
    grid_.reset();
    bounds_ = {};
    findBounds();
    return std::move(*this);
}

void PointCloud::keepDrawnAttributes() {
    std::vector<std::uint8_t>& classes = attributes_.classification;
    if (std::all_of(classes.begin(), classes.end(), [](std::uint8_t one) { return one == 0; })) classes = {};
    attributes_.gpsTime = {};
    attributes_.pointSource = {};
    attributes_.returnNumber = {};
    attributes_.returnCount = {};
}

PointCloud PointCloud::withAttributes(PointAttributes attributes) const {
    PointCloud cloud;
    cloud.origin_ = origin_;
    cloud.offsets_ = offsets_;
    cloud.residuals_ = residuals_;
    cloud.grid_ = grid_;
    cloud.bounds_ = bounds_;
    cloud.attributes_ = std::move(attributes);
    return cloud;
}

}  // namespace vestige
