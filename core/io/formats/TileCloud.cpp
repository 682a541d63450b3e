#include "core/io/formats/TileCloud.h"

#include <algorithm>
#include <cmath>

#include "core/io/Describe.h"
#include "core/io/FieldValues.h"

namespace vestige {
namespace {

constexpr std::size_t kMostReserved = std::size_t{1} << 24;

}  // namespace

TileCloud::TileCloud(const ReadOptions& options)
    : box_(options.box),
      keepEvery_(std::max<std::uint32_t>(1, options.keepEvery)),
      all_(options.attributes == ReadOptions::Attributes::all) {}

void TileCloud::beginTile(const TileAttributes& attributes, std::size_t points) {
    if (!first_ && !(attributes == any_) && points > 0) partial_ = true;
    if (first_ && !box_) builder_.reserve(std::min(points / keepEvery_ + 1, kMostReserved));
    if (points > 0) first_ = false;
    any_.add(attributes);
    padAttributes();
}

void TileCloud::padAttributes() {
    PointAttributes& attributes = builder_.attributes();
    const std::size_t size = builder_.size();
    const auto pad = [size](auto& values, bool present) {
        if (present) values.resize(size);
    };
    pad(attributes.color, any_.color);
    if (any_.normals) attributes.normal.resize(size, Eigen::Vector3f::Zero());
    const auto kept = [&](PointField field) { return any_[field] && wants(field); };
    pad(attributes.intensity, kept(PointField::intensity));
    pad(attributes.classification, kept(PointField::classification));
    pad(attributes.gpsTime, kept(PointField::gpsTime));
    pad(attributes.pointSource, kept(PointField::pointSource));
    pad(attributes.returnNumber, kept(PointField::returnNumber));
    pad(attributes.returnCount, kept(PointField::returnCount));
}

bool TileCloud::add(const Eigen::Vector3d& point) {
    if (box_ && !box_->contains(point)) return false;
    if (met_++ % keepEvery_ != 0) return false;
    builder_.add(point);
    return true;
}

void TileCloud::addValue(PointField field, double value) {
    appendValue(builder_.attributes(), field, value);
}

LoadedGeometry TileCloud::finish(std::string format, std::string version, ReadJob& job) && {
    padAttributes();
    if (partial_)
        job.warn("not all tiles have the same attributes; those that a tile lacks are zero in its points");
    LoadedGeometry result =
        loaded({std::move(builder_).build(), {}}, std::move(format), std::move(version), job);
    result.info.attributes = any_.names();
    result.info.metresPerUnit = 1;
    result.heeded = true;
    return result;
}

}  // namespace vestige
