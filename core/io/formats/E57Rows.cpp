#include "core/io/formats/E57Rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Numbers.h"
#include "core/io/PointSink.h"
#include "core/io/formats/E57Time.h"

namespace vestige {
namespace {

constexpr std::array kPosition{E57Role::x,
                               E57Role::y,
                               E57Role::z,
                               E57Role::range,
                               E57Role::azimuth,
                               E57Role::elevation,
                               E57Role::cartesianInvalid,
                               E57Role::sphericalInvalid};
constexpr std::array kUndrawn{E57Role::time, E57Role::timeInvalid, E57Role::pointSource, E57Role::returnIndex,
                              E57Role::returnCount};

template <class Roles>
bool among(const Roles& roles, E57Role role) {
    return std::find(roles.begin(), roles.end(), role) != roles.end();
}

}  // namespace

E57Rows::E57Rows(const E57Scan& scan, bool drawnOnly)
    : scan_(scan),
      cartesian_(scan.hasAll({E57Role::x, E57Role::y, E57Role::z})),
      timeOffset_(e57TimeOffset(scan.timeStart)) {
    constexpr std::array kCartesian{E57Role::x, E57Role::y, E57Role::z, E57Role::cartesianInvalid};
    constexpr std::array kSpherical{E57Role::range, E57Role::azimuth, E57Role::elevation,
                                    E57Role::sphericalInvalid};
    for (const E57Field& field : scan.fields) {
        if (field.role == E57Role::none || (drawnOnly && among(kUndrawn, field.role))) continue;
        const auto& used = cartesian_ ? kCartesian : kSpherical;
        if (!among(kPosition, field.role) || among(used, field.role)) wanted_.push_back(field.role);
    }
}

void E57Rows::decode(const E57Streams& streams, std::uint64_t first, std::size_t count) {
    size_ = count;
    for (const E57Role role : wanted_) {
        columns_[index(role)].resize(count);
        streams.decode(scan_.find(role), first, columns_[index(role)], bytes_);
    }
}

void E57Rows::check(const E57Streams& streams, std::uint64_t first, std::uint64_t count,
                    const ReadJob& job) const {
    for (const E57Role role : wanted_) streams.check(scan_.find(role), first, count, job);
}

bool E57Rows::valid(std::size_t i) const {
    return !flagged(cartesian_ ? E57Role::cartesianInvalid : E57Role::sphericalInvalid, i);
}

Eigen::Vector3d E57Rows::point(std::size_t i) const {
    if (cartesian_)
        return scan_.info.fileFromScan *
               Eigen::Vector3d(value(E57Role::x, i), value(E57Role::y, i), value(E57Role::z, i));
    const double range = value(E57Role::range, i);
    const double azimuth = value(E57Role::azimuth, i);
    const double elevation = value(E57Role::elevation, i);
    const double across = range * std::cos(elevation);
    return scan_.info.fileFromScan * Eigen::Vector3d(across * std::cos(azimuth), across * std::sin(azimuth),
                                                     range * std::sin(elevation));
}

float E57Rows::intensity(std::size_t i) const {
    return flagged(E57Role::intensityInvalid, i) ? 0 : toFloat(value(E57Role::intensity, i));
}

Color E57Rows::color(std::size_t i) const {
    if (flagged(E57Role::colorInvalid, i)) return {};
    constexpr std::array kChannels{E57Role::red, E57Role::green, E57Role::blue};
    Color color{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto [low, high] = scan_.colorLimits[channel];
        const double spread = (value(kChannels[channel], i) - low) * (65535.0 / (high - low));
        color[channel] =
            static_cast<std::uint16_t>(std::nearbyint(spread > 0 ? std::min(spread, 65535.0) : 0));
    }
    return color;
}

double E57Rows::time(std::size_t i) const {
    if (flagged(E57Role::timeInvalid, i)) return std::numeric_limits<double>::quiet_NaN();
    return timeOffset_ + value(E57Role::time, i);
}

Eigen::Vector3f E57Rows::normal(std::size_t i) const {
    return cleanNormal(scan_.info.fileFromScan.linear() * Eigen::Vector3d(value(E57Role::normalX, i),
                                                                          value(E57Role::normalY, i),
                                                                          value(E57Role::normalZ, i)));
}

}  // namespace vestige
