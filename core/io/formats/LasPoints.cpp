#include "core/io/formats/LasPoints.h"

#include <algorithm>
#include <cmath>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

/// Flags and classes, whose bits differ between the formats before and since 6 (LAS 1.4, tables 7 and 16).
void decodeFlags(const std::byte* record, bool extended, LasPoint& point) {
    const auto returns = load<std::uint8_t>(record + 14);
    if (extended) {
        point.returnNumber = returns & 15;
        point.returnCount = returns >> 4;
        point.withheld = (load<std::uint8_t>(record + 15) & 4) != 0;
        point.classification = load<std::uint8_t>(record + 16);
        point.pointSource = load<std::uint16_t>(record + 20);
    } else {
        point.returnNumber = returns & 7;
        point.returnCount = returns >> 3 & 7;
        const auto classification = load<std::uint8_t>(record + 15);
        point.withheld = (classification & 0x80) != 0;
        point.classification = classification & 31;
        point.pointSource = load<std::uint16_t>(record + 18);
    }
}

}  // namespace

void readLasPoints(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job,
                   const LasPointHandler& handle) {
    const LasPointLayout& layout = lasPointLayout(header.pointFormat);
    LasPoint point;
    for (std::uint64_t i = 0; i < header.points; ++i) {
        job.step(i, header.points);
        const std::byte* record = file.data() + header.pointOffset + i * header.recordLength;
        for (int axis = 0; axis < 3; ++axis)
            point.position[axis] =
                load<std::int32_t>(record + 4 * axis) * header.scale[axis] + header.offset[axis];
        point.intensity = load<std::uint16_t>(record + 12);
        decodeFlags(record, layout.extended, point);
        if (layout.gpsTime) point.gpsTime = load<double>(record + layout.gpsTime);
        if (layout.color)
            for (std::size_t channel = 0; channel < 3; ++channel)
                point.color[channel] = load<std::uint16_t>(record + layout.color + 2 * channel);
        handle(point);
    }
}

void LasCloud::add(const LasPoint& point) {
    builder_.add(point.position);
    PointAttributes& attributes = builder_.attributes();
    attributes.intensity.push_back(point.intensity);
    attributes.classification.push_back(point.classification);
    attributes.pointSource.push_back(point.pointSource);
    attributes.returnNumber.push_back(point.returnNumber);
    attributes.returnCount.push_back(point.returnCount);
    if (layout_.gpsTime) attributes.gpsTime.push_back(point.gpsTime);
    if (layout_.color) {
        attributes.color.push_back(point.color);
        for (const std::uint16_t channel : point.color) brightest_ = std::max(brightest_, channel);
    }
    if (point.withheld) ++withheld_;
}

PointCloud LasCloud::build(ReadJob& job) && {
    if (withheld_ > 0) job.warn(counted(withheld_, "point") + " marked as withheld, read all the same");
    // Formats 6 and later cannot leave the time out; zero throughout means that there is none.
    std::vector<double>& times = builder_.attributes().gpsTime;
    if (layout_.extended && std::all_of(times.begin(), times.end(), [](double time) { return time == 0; }))
        times = {};
    std::vector<Color>& colors = builder_.attributes().color;
    if (brightest_ > 0 && brightest_ <= 255) {
        job.warn("colours are 8 bit in the file, spread to 16 bit");
        for (Color& color : colors)
            for (std::uint16_t& channel : color) channel = static_cast<std::uint16_t>(channel * 257);
    }
    return std::move(builder_).build();
}

void LasSummary::add(const LasPoint& point) {
    ++points_;
    bounds_.add(point.position);
    if (!std::isfinite(point.gpsTime)) return;
    if (!timeSpan_) timeSpan_.emplace(point.gpsTime, point.gpsTime);
    timeSpan_->first = std::min(timeSpan_->first, point.gpsTime);
    timeSpan_->second = std::max(timeSpan_->second, point.gpsTime);
}

void LasSummary::describe(const LasHeader& header, FileInfo& info) const {
    const LasPointLayout& layout = lasPointLayout(header.pointFormat);
    const bool timed = layout.gpsTime && !(layout.extended && timeSpan_ == std::pair(0.0, 0.0));
    info.points = points_;
    info.bounds = bounds_;
    info.attributes = {"intensity"};
    if (layout.color) info.attributes.emplace_back("color");
    info.attributes.emplace_back("classification");
    if (timed) info.attributes.emplace_back("gps_time");
    for (const char* name : {"point_source", "return_number", "return_count"})
        info.attributes.emplace_back(name);
    if (timed) info.timeSpan = timeSpan_;
}

}  // namespace vestige
