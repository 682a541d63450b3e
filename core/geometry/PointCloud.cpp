#include "core/geometry/PointCloud.h"

#include <utility>

#include "core/base/Parallel.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 16384;

template <class Value>
std::vector<Value> selected(const std::vector<Value>& all, std::span<const std::uint32_t> indices) {
    std::vector<Value> chosen;
    if (all.empty()) return chosen;
    chosen.reserve(indices.size());
    for (const std::uint32_t index : indices) chosen.push_back(all[index]);
    return chosen;
}

}  // namespace

PointAttributes PointAttributes::select(std::span<const std::uint32_t> indices) const {
    PointAttributes chosen;
    chosen.intensity = selected(intensity, indices);
    chosen.color = selected(color, indices);
    chosen.classification = selected(classification, indices);
    chosen.gpsTime = selected(gpsTime, indices);
    chosen.normal = selected(normal, indices);
    chosen.pointSource = selected(pointSource, indices);
    chosen.returnNumber = selected(returnNumber, indices);
    chosen.returnCount = selected(returnCount, indices);
    return chosen;
}

PointCloud::PointCloud(Eigen::Vector3d origin, std::vector<Eigen::Vector3f> offsets,
                       std::vector<Eigen::Vector3f> residuals, PointAttributes attributes)
    : origin_(std::move(origin)),
      offsets_(std::move(offsets)),
      residuals_(std::move(residuals)),
      attributes_(std::move(attributes)) {
    for (std::size_t i = 0; i < size(); ++i) bounds_.add(point(i));
}

PointCloud PointCloud::select(std::span<const std::uint32_t> indices) const {
    return {origin_, selected(offsets_, indices), selected(residuals_, indices), attributes_.select(indices)};
}

PointCloud PointCloud::transformed(const Similarity& toFromHere) const {
    if (toFromHere.isIdentity()) return *this;
    PointCloudBuilder builder(toFromHere * origin_);
    builder.resize(size());
    PointAttributes attributes = attributes_;
    const Eigen::Matrix3f rotation = toFromHere.pose.linear().cast<float>();
    parallelFor(size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            builder.setPoint(i, toFromHere * point(i));
            if (!attributes.normal.empty()) attributes.normal[i] = rotation * attributes.normal[i];
        }
    });
    builder.attributes() = std::move(attributes);
    return std::move(builder).build();
}

PointCloud PointCloud::withAttributes(PointAttributes attributes) const {
    PointCloud cloud = *this;
    cloud.attributes_ = std::move(attributes);
    return cloud;
}

}  // namespace vestige
