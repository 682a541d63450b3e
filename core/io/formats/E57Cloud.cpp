#include "core/io/formats/E57Cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/io/AttributeNames.h"

namespace vestige {
namespace {

std::uint8_t byteOf(const E57Rows& rows, E57Role role, std::size_t i, double plus) {
    return rows.has(role) ? rows.whole<std::uint8_t>(role, i, plus) : std::uint8_t{0};
}

}  // namespace

E57Attributes::E57Attributes(const E57Document& document) {
    for (const E57Scan& scan : document.scans) {
        intensity |= scan.has(E57Role::intensity);
        color |= scan.hasAll({E57Role::red, E57Role::green, E57Role::blue});
        classification |= scan.has(E57Role::classification);
        time |= scan.has(E57Role::time);
        normal |= scan.hasAll({E57Role::normalX, E57Role::normalY, E57Role::normalZ});
        source |= scan.has(E57Role::pointSource);
        returnNumber |= scan.has(E57Role::returnIndex);
        returnCount |= scan.has(E57Role::returnCount);
    }
    source |= document.scans.size() > 1;
}

std::vector<std::string> E57Attributes::names() const {
    return attributeNames({.intensity = intensity,
                           .color = color,
                           .classification = classification,
                           .gpsTime = time,
                           .normals = normal,
                           .pointSource = source,
                           .returnNumber = returnNumber,
                           .returnCount = returnCount});
}

E57Cloud::E57Cloud(const E57Document& document, const ReadOptions& options)
    : options_(options), attributes_(document), severalScans_(document.scans.size() > 1) {
    if (options.attributes == ReadOptions::Attributes::drawn) attributes_.leaveUndrawn();
}

void E57Cloud::reserve(std::size_t points) {
    builder_.reserve(points);
    PointAttributes& to = builder_.attributes();
    if (attributes_.color) to.color.reserve(points);
    if (attributes_.normal) to.normal.reserve(points);
    if (attributes_.classification) to.classification.reserve(points);
    if (attributes_.time) to.gpsTime.reserve(points);
    if (attributes_.source) to.pointSource.reserve(points);
    if (attributes_.returnNumber) to.returnNumber.reserve(points);
    if (attributes_.returnCount) to.returnCount.reserve(points);
}

void E57Cloud::beginScan(std::size_t place) {
    number_ = static_cast<std::uint16_t>(std::min<std::size_t>(place + 1, 65535));
    firstOfScan_ = builder_.size();
    ofScan_ = 0;
    leastReturn_ = 255;
    returnIsCount_ = false;
}

void E57Cloud::add(const E57Rows& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows.valid(i)) {
            ++invalid_;
            continue;
        }
        const Eigen::Vector3d point = rows.point(i);
        if (!point.allFinite()) {
            ++notFinite_;
            continue;
        }
        ++ofScan_;
        seeReturn(rows, i);
        if (options_.box && !options_.box->contains(point)) continue;
        if (met_++ % std::max<std::uint32_t>(1, options_.keepEvery) != 0) continue;
        builder_.add(point);
        addAttributes(rows, i);
    }
}

void E57Cloud::seeReturn(const E57Rows& rows, std::size_t i) {
    if (!rows.has(E57Role::returnIndex) || !rows.has(E57Role::returnCount)) return;
    const double number = rows.value(E57Role::returnIndex, i);
    leastReturn_ = std::min(leastReturn_, number);
    returnIsCount_ |= number == rows.value(E57Role::returnCount, i);
}

void E57Cloud::addAttributes(const E57Rows& rows, std::size_t i) {
    PointAttributes& to = builder_.attributes();
    if (attributes_.intensity)
        to.intensity.push_back(rows.has(E57Role::intensity) ? rows.intensity(i) : 0.0F);
    if (attributes_.color) to.color.push_back(rows.hasColor() ? rows.color(i) : Color{});
    if (attributes_.normal) to.normal.push_back(rows.hasNormal() ? rows.normal(i) : Eigen::Vector3f::Zero());
    if (attributes_.classification) to.classification.push_back(byteOf(rows, E57Role::classification, i, 0));
    if (attributes_.time)
        to.gpsTime.push_back(rows.has(E57Role::time) ? rows.time(i)
                                                     : std::numeric_limits<double>::quiet_NaN());
    if (attributes_.source)
        to.pointSource.push_back(severalScans_ ? number_
                                               : rows.whole<std::uint16_t>(E57Role::pointSource, i));
    // E57 numbers returns from 0, LAS and Vestige from 1.
    if (attributes_.returnNumber) to.returnNumber.push_back(byteOf(rows, E57Role::returnIndex, i, 1));
    if (attributes_.returnCount) to.returnCount.push_back(byteOf(rows, E57Role::returnCount, i, 0));
}

std::uint64_t E57Cloud::endScan(ReadJob& job) {
    // E57 numbers returns from 0; las2e57 copies the numbers of LAS, from 1.
    auto& numbers = builder_.attributes().returnNumber;
    if (leastReturn_ >= 1 && returnIsCount_ && !numbers.empty()) {
        for (std::size_t i = firstOfScan_; i < numbers.size(); ++i)
            numbers[i] = static_cast<std::uint8_t>(numbers[i] - 1);
        job.warn("the returns are numbered from 1 in the file, which the standard counts from 0");
    }
    return ofScan_;
}

PointCloud E57Cloud::build(ReadJob& job) && {
    if (invalid_ > 0)
        job.warn(counted(invalid_, "record") + " without a position left out: the scanner got no echo there");
    if (notFinite_ > 0) job.warn(counted(notFinite_, "point") + " without finite coordinates left out");
    return std::move(builder_).build();
}

}  // namespace vestige
