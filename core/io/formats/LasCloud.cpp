#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/io/formats/LasPoints.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;

std::array<std::int32_t, 3> stepsIn(const Eigen::Vector3f& bits) {
    return {std::bit_cast<std::int32_t>(bits.x()), std::bit_cast<std::int32_t>(bits.y()),
            std::bit_cast<std::int32_t>(bits.z())};
}

}  // namespace

LasCloud::LasCloud(const LasHeader& header, ReadOptions::Attributes attributes)
    : header_(header),
      layout_(lasPointLayout(header.pointFormat)),
      all_(attributes == ReadOptions::Attributes::all) {}

void LasCloud::resize(std::size_t points) {
    steps_.resize(points);
    intensity_.resize(points);
    if (layout_.color) attributes_.color.resize(points);
    if (!all_) return;
    attributes_.classification.resize(points);
    attributes_.pointSource.resize(points);
    attributes_.returnNumber.resize(points);
    attributes_.returnCount.resize(points);
    if (layout_.gpsTime) attributes_.gpsTime.resize(points);
}

void LasCloud::set(std::size_t place, const LasPoint& point) {
    for (int axis = 0; axis < 3; ++axis)
        steps_[place][axis] = std::bit_cast<float>(point.steps[static_cast<std::size_t>(axis)]);
    intensity_[place] = point.intensity;
    if (layout_.color) attributes_.color[place] = point.color;
    if (!all_) return;
    attributes_.classification[place] = point.classification;
    attributes_.pointSource[place] = point.pointSource;
    attributes_.returnNumber[place] = point.returnNumber;
    attributes_.returnCount[place] = point.returnCount;
    if (layout_.gpsTime) attributes_.gpsTime[place] = point.gpsTime;
}

void LasCloud::note(std::uint64_t withheld, std::uint16_t brightest) {
    withheld_ += withheld;
    brightest_ = std::max(brightest_, brightest);
}

LasCloud::Reach LasCloud::reach() const {
    std::vector<Reach> parts((steps_.size() + kGrain - 1) / kGrain);
    parallelChunks(steps_.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        Reach part{stepsIn(steps_[begin]), stepsIn(steps_[begin])};
        for (std::size_t i = begin + 1; i < end; ++i) {
            const std::array<std::int32_t, 3> steps = stepsIn(steps_[i]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                part.least[axis] = std::min(part.least[axis], steps[axis]);
                part.most[axis] = std::max(part.most[axis], steps[axis]);
            }
        }
        parts[chunk] = part;
    });
    Reach all = parts.front();
    for (const Reach& part : parts)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            all.least[axis] = std::min(all.least[axis], part.least[axis]);
            all.most[axis] = std::max(all.most[axis], part.most[axis]);
        }
    return all;
}

PointCloud LasCloud::build(ReadJob& job) && {
    if (withheld_ > 0) job.warn(counted(withheld_, "point") + " marked as withheld, read all the same");
    // Formats 6 and later cannot leave the time out; zero throughout means that there is none.
    std::vector<double>& times = attributes_.gpsTime;
    if (layout_.extended && std::all_of(times.begin(), times.end(), [](double time) { return time == 0; }))
        times = {};
    if (brightest_ > 0 && brightest_ <= 255) {
        job.warn("colours are 8 bit in the file, spread to 16 bit");
        parallelFor(attributes_.color.size(), kGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (std::uint16_t& channel : attributes_.color[i])
                    channel = static_cast<std::uint16_t>(channel * 257);
        });
    }
    attributes_.intensity = Intensities(std::move(intensity_));
    if (steps_.empty()) return {};

    const Reach points = reach();
    const Eigen::Vector3d least = lasPosition(header_, points.least);
    const Eigen::Vector3d most = lasPosition(header_, points.most);
    const Eigen::Vector3d origin = (0.5 * (least + most)).array().round().matrix();
    const Eigen::Vector3f farthest =
        (least - origin).cwiseAbs().cwiseMax((most - origin).cwiseAbs()).cast<float>();
    const CoordinateGrid grid{header_.scale, header_.offset};
    const bool onGrid = grid.heldByFloats(farthest);
    LargeArray<Eigen::Vector3f> residuals;
    if (!onGrid) residuals.resize(steps_.size());
    parallelFor(steps_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d offset = lasPosition(header_, stepsIn(steps_[i])) - origin;
            steps_[i] = offset.cast<float>();
            if (!onGrid) residuals[i] = (offset - steps_[i].cast<double>()).cast<float>();
        }
    });
    if (onGrid) return {origin, std::move(steps_), grid, std::move(attributes_)};
    return {origin, std::move(steps_), std::move(residuals), std::move(attributes_)};
}

}  // namespace vestige
