#include <algorithm>
#include <cmath>

#include "core/io/AttributeNames.h"
#include "core/io/formats/LasPoints.h"

namespace vestige {

void LasSummary::add(const LasHeader& header, const LasPoint& point) {
    ++points_;
    bounds_.add(lasPosition(header, point.steps));
    if (!std::isfinite(point.gpsTime)) return;
    if (!timeSpan_) timeSpan_.emplace(point.gpsTime, point.gpsTime);
    timeSpan_->first = std::min(timeSpan_->first, point.gpsTime);
    timeSpan_->second = std::max(timeSpan_->second, point.gpsTime);
}

void LasSummary::add(const LasSummary& other) {
    points_ += other.points_;
    bounds_.add(other.bounds_);
    if (!other.timeSpan_) return;
    if (!timeSpan_) timeSpan_ = other.timeSpan_;
    timeSpan_->first = std::min(timeSpan_->first, other.timeSpan_->first);
    timeSpan_->second = std::max(timeSpan_->second, other.timeSpan_->second);
}

void LasSummary::describe(const LasHeader& header, FileInfo& info) const {
    const LasPointLayout& layout = lasPointLayout(header.pointFormat);
    const bool timed = layout.gpsTime && !(layout.extended && timeSpan_ == std::pair(0.0, 0.0));
    info.points = points_;
    info.bounds = bounds_;
    info.attributes = lasAttributes(layout, timed);
    if (timed) info.timeSpan = timeSpan_;
}

std::vector<std::string> lasAttributes(const LasPointLayout& layout, bool timed) {
    return attributeNames({.intensity = true,
                           .color = layout.color != 0,
                           .classification = true,
                           .gpsTime = timed,
                           .pointSource = true,
                           .returnNumber = true,
                           .returnCount = true});
}

}  // namespace vestige
