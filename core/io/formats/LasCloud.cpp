#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/Parallel.h"
#include "core/io/formats/LasPoints.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;

struct Corners {
    Eigen::Vector3d a;
    Eigen::Vector3d b;
};
Corners cornersOf(const LasHeader& header, const LasNotes& notes) {
    return {lasPosition(header, notes.least), lasPosition(header, notes.most)};
}

}  // namespace

LasCloud::LasCloud(const LasHeader& header, ReadOptions::Attributes attributes, const Eigen::Vector3d& origin,
                   bool exact)
    : header_(header),
      layout_(lasPointLayout(header.pointFormat)),
      all_(attributes == ReadOptions::Attributes::all),
      origin_(origin),
      exact_(exact) {}

void LasCloud::resize(std::size_t points) {
    offsets_.resizeToFill(points);
    if (exact_) residuals_.resizeToFill(points);
    intensity_.resizeToFill(points);
    if (layout_.color) attributes_.color.resizeToFill(points);
    attributes_.classification.resize(points);
    if (!all_) return;
    attributes_.pointSource.resize(points);
    attributes_.returnNumber.resize(points);
    attributes_.returnCount.resize(points);
    if (layout_.gpsTime) attributes_.gpsTime.resize(points);
}

void LasCloud::set(std::size_t place, const LasPoint& point) {
    const Eigen::Vector3d offset = lasPosition(header_, point.steps) - origin_;
    offsets_[place] = offset.cast<float>();
    if (exact_) residuals_[place] = (offset - offsets_[place].cast<double>()).cast<float>();
    intensity_[place] = point.intensity;
    if (layout_.color) attributes_.color[place] = point.color;
    attributes_.classification[place] = point.classification;
    if (!all_) return;
    attributes_.pointSource[place] = point.pointSource;
    attributes_.returnNumber[place] = point.returnNumber;
    attributes_.returnCount[place] = point.returnCount;
    if (layout_.gpsTime) attributes_.gpsTime[place] = point.gpsTime;
}

template <bool kColor>
void LasCloud::setDrawn(std::size_t place, const std::byte* records, std::size_t count, LasNotes& notes) {
    const std::size_t stride = header_.recordLength;
    constexpr std::size_t kFlags = 15;
    const std::uint8_t withheld = layout_.extended ? 4 : 0x80;
    // LAS 1.4, tables 7 and 16.
    const std::size_t classAt = layout_.extended ? 16 : 15;
    const std::uint8_t classBits = layout_.extended ? 255 : 31;
    const Eigen::Vector3d scale = header_.scale;
    const Eigen::Vector3d shift = header_.offset;
    const Eigen::Vector3d origin = origin_;
    float* const offsets = offsets_[place].data();
    std::uint16_t* const intensity = &intensity_[place];
    std::uint8_t* const classes = &attributes_.classification[place];
    Color* const color = kColor ? &attributes_.color[place] : nullptr;
    LasNotes own;
    own.points = count;
    std::memcpy(own.least.data(), records, 12);
    own.most = own.least;
    for (std::size_t i = 0; i < count; ++i, records += stride) {
        std::int32_t steps[3];
        std::memcpy(steps, records, 12);
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            own.least[at] = std::min(own.least[at], steps[axis]);
            own.most[at] = std::max(own.most[at], steps[axis]);
            offsets[3 * i + at] =
                static_cast<float>((steps[axis] * scale[axis] + shift[axis]) - origin[axis]);
        }
        std::memcpy(intensity + i, records + 12, 2);
        classes[i] = static_cast<std::uint8_t>(records[classAt]) & classBits;
        own.withheld += (static_cast<std::uint8_t>(records[kFlags]) & withheld) != 0 ? 1U : 0U;
        if constexpr (kColor) {
            std::memcpy(color + i, records + layout_.color, 6);
            own.brightest = std::max({own.brightest, color[i][0], color[i][1], color[i][2]});
        }
    }
    notes.add(own);
}

void LasCloud::setRecords(std::size_t place, const std::byte* records, std::size_t count, LasNotes& notes) {
    if (count == 0) return;
    if (layout_.color)
        setDrawn<true>(place, records, count, notes);
    else
        setDrawn<false>(place, records, count, notes);
}

bool LasCloud::holds(const LasNotes& notes) const {
    if (exact_ || notes.points == 0) return true;
    const Corners corners = cornersOf(header_, notes);
    const Eigen::Vector3d farthest =
        (corners.a - origin_).cwiseAbs().cwiseMax((corners.b - origin_).cwiseAbs());
    return CoordinateGrid{header_.scale, header_.offset}.heldByFloats(farthest.cast<float>());
}

PointCloud LasCloud::build(const LasNotes& notes, ReadJob& job) && {
    if (notes.withheld > 0)
        job.warn(counted(notes.withheld, "point") + " marked as withheld, read all the same");
    // Formats 6 and later cannot leave the time out; zero throughout means that there is none.
    std::vector<std::uint8_t>& classes = attributes_.classification;
    if (!all_ && std::all_of(classes.begin(), classes.end(), [](std::uint8_t one) { return one == 0; }))
        classes = {};
    std::vector<double>& times = attributes_.gpsTime;
    if (layout_.extended && std::all_of(times.begin(), times.end(), [](double time) { return time == 0; }))
        times = {};
    if (notes.brightest > 0 && notes.brightest <= 255) {
        job.warn("colours are 8 bit in the file, spread to 16 bit");
        parallelFor(attributes_.color.size(), kGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (std::uint16_t& channel : attributes_.color[i])
                    channel = static_cast<std::uint16_t>(channel * 257);
        });
    }
    attributes_.intensity = Intensities(std::move(intensity_));
    if (offsets_.empty()) return {};
    if (exact_) return {origin_, std::move(offsets_), std::move(residuals_), std::move(attributes_)};
    const Corners corners = cornersOf(header_, notes);
    BoundingBox bounds;
    bounds.add(corners.a);
    bounds.add(corners.b);
    return {origin_, std::move(offsets_), CoordinateGrid{header_.scale, header_.offset}, bounds,
            std::move(attributes_)};
}

}  // namespace vestige
