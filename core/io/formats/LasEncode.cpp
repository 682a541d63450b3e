#include "core/io/formats/LasEncode.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/Version.h"
#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr double kLargest = 2147483000;  // a little inside int32
constexpr double kDefaultScale = 0.0001;

bool fits(const LasGrid& grid, const BoundingBox& bounds) {
    const Eigen::Array3d low = (bounds.min - grid.offset).array() / grid.scale.array();
    const Eigen::Array3d high = (bounds.max - grid.offset).array() / grid.scale.array();
    return (low.abs() <= kLargest).all() && (high.abs() <= kLargest).all();
}

void storeText(std::byte* at, std::string_view text, std::size_t room) {
    for (std::size_t i = 0; i < std::min(text.size(), room); ++i) at[i] = static_cast<std::byte>(text[i]);
}

template <class Values>
typename Values::value_type valueAt(const Values& values, std::size_t i) {
    return values.empty() ? typename Values::value_type{} : values[i];
}

std::uint16_t globalEncoding(const LasWriteOptions& options) {
    constexpr std::uint16_t kWkt = 2112;
    const bool wkt = std::any_of(options.crsRecords.begin(), options.crsRecords.end(),
                                 [](const CrsRecord& record) { return record.recordId == kWkt; });
    // Point formats 6 and later ask for WKT; GeoTIFF keys alone are kept and said to be what they are.
    return static_cast<std::uint16_t>((options.gpsTimeIsAdjustedStandard ? 1 : 0) |
                                      (wkt || options.crsRecords.empty() ? 16 : 0));
}

std::vector<std::byte> recordHeader(const CrsRecord& record, std::size_t size) {
    std::vector<std::byte> bytes(size);
    storeText(bytes.data() + 2, record.userId, 16);
    store<std::uint16_t>(bytes.data() + 18, record.recordId);
    storeText(bytes.data() + size - 32, record.description, 32);
    return bytes;
}

void append(std::vector<std::byte>& bytes, const std::vector<std::uint8_t>& content) {
    for (const std::uint8_t byte : content) bytes.push_back(static_cast<std::byte>(byte));
}

}  // namespace

std::array<std::int32_t, 3> LasGrid::integers(const Eigen::Vector3d& point) const {
    std::array<std::int32_t, 3> result{};
    for (int axis = 0; axis < 3; ++axis)
        result[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(std::clamp(
            std::nearbyint((point[axis] - offset[axis]) / scale[axis]), -2147483648.0, 2147483647.0));
    return result;
}

Eigen::Vector3d LasGrid::coordinates(const std::array<std::int32_t, 3>& integers) const {
    return Eigen::Vector3d(integers[0] * scale.x(), integers[1] * scale.y(), integers[2] * scale.z()) +
           offset;
}

LasGrid chooseGrid(const LasWriteOptions& options, const BoundingBox& bounds) {
    LasGrid grid{Eigen::Vector3d::Constant(kDefaultScale), Eigen::Vector3d::Zero()};
    if (options.scale && options.scale->allFinite() && (options.scale->array() > 0).all())
        grid.scale = *options.scale;
    const Eigen::Vector3d centre = bounds.empty() ? Eigen::Vector3d::Zero() : bounds.centre();
    grid.offset = options.offset.value_or(centre.array().round().matrix());
    if (bounds.empty() || fits(grid, bounds)) return grid;
    if (options.offset)
        grid.offset +=
            (((centre - grid.offset).array() / grid.scale.array()).round() * grid.scale.array()).matrix();
    if (fits(grid, bounds)) return grid;
    grid.offset = centre.array().round().matrix();
    for (int axis = 0; axis < 3; ++axis) {
        const double reach =
            std::max(bounds.max[axis] - grid.offset[axis], grid.offset[axis] - bounds.min[axis]);
        while (reach / grid.scale[axis] > kLargest) grid.scale[axis] *= 10;
    }
    return grid;
}

std::vector<std::byte> encodePoint(const LasPart& part, std::size_t i,
                                   const std::array<std::int32_t, 3>& integers, bool colored,
                                   bool keepPointSource) {
    const PointAttributes& attributes = part.cloud->attributes();
    std::vector<std::byte> record(lasRecordLength(colored));
    for (std::size_t axis = 0; axis < 3; ++axis) store(record.data() + 4 * axis, integers[axis]);
    const float intensity = valueAt(attributes.intensity, i);
    store<std::uint16_t>(
        record.data() + 12,
        static_cast<std::uint16_t>(std::nearbyint(intensity > 0 ? std::min(intensity, 65535.0F) : 0.0F)));
    // A point is the first of one return where nothing else is known.
    const int number = attributes.returnNumber.empty() ? 1 : std::min<int>(attributes.returnNumber[i], 15);
    const int count =
        attributes.returnCount.empty() ? std::max(number, 1) : std::min<int>(attributes.returnCount[i], 15);
    store<std::uint8_t>(record.data() + 14, static_cast<std::uint8_t>(number | count << 4));
    store<std::uint8_t>(record.data() + 16, valueAt(attributes.classification, i));
    const bool ownSource = keepPointSource && !attributes.pointSource.empty();
    store<std::uint16_t>(record.data() + 20, ownSource ? attributes.pointSource[i] : part.pointSource);
    store<double>(record.data() + 22, valueAt(attributes.gpsTime, i));
    if (colored) {
        const Color color = valueAt(attributes.color, i);
        for (std::size_t channel = 0; channel < 3; ++channel)
            store(record.data() + 30 + 2 * channel, color[channel]);
    }
    return record;
}

std::vector<std::byte> encodeRecord(const CrsRecord& record) {
    std::vector<std::byte> bytes = recordHeader(record, 54);
    store<std::uint16_t>(bytes.data() + 20, static_cast<std::uint16_t>(record.bytes.size()));
    append(bytes, record.bytes);
    return bytes;
}

std::vector<std::byte> encodeExtendedRecord(const CrsRecord& record) {
    std::vector<std::byte> bytes = recordHeader(record, 60);
    store<std::uint64_t>(bytes.data() + 20, record.bytes.size());
    append(bytes, record.bytes);
    return bytes;
}

std::vector<std::byte> encodeHeader(const LasWriteOptions& options, const LasPlan& plan, const LasGrid& grid,
                                    const LasTotals& totals) {
    const std::string program = std::string("Vestige ") + kVersion;
    std::vector<std::byte> bytes(kLasHeaderSize);
    std::byte* at = bytes.data();
    storeText(at, "LASF", 4);
    store<std::uint16_t>(at + 6, globalEncoding(options));
    for (std::size_t i = 0; i < options.guid.size(); ++i) at[8 + i] = static_cast<std::byte>(options.guid[i]);
    store<std::uint8_t>(at + 24, 1);
    store<std::uint8_t>(at + 25, 4);
    storeText(at + 26, program, 32);
    storeText(at + 58, program, 32);
    store<std::uint16_t>(at + 90, static_cast<std::uint16_t>(options.creationDay));
    store<std::uint16_t>(at + 92, static_cast<std::uint16_t>(options.creationYear));
    store<std::uint16_t>(at + 94, kLasHeaderSize);
    store<std::uint32_t>(at + 96, static_cast<std::uint32_t>(plan.pointOffset));
    store<std::uint32_t>(at + 100, static_cast<std::uint32_t>(plan.records));
    store<std::uint8_t>(at + 104,
                        static_cast<std::uint8_t>((plan.colored ? 7 : 6) | (plan.compressed ? 0x80 : 0)));
    store<std::uint16_t>(at + 105, static_cast<std::uint16_t>(lasRecordLength(plan.colored)));
    for (int axis = 0; axis < 3; ++axis) {
        const auto place = static_cast<std::size_t>(axis);
        store<double>(at + 131 + 8 * place, grid.scale[axis]);
        store<double>(at + 155 + 8 * place, grid.offset[axis]);
        store<double>(at + 179 + 16 * place, totals.points > 0 ? totals.bounds.max[axis] : 0);
        store<double>(at + 187 + 16 * place, totals.points > 0 ? totals.bounds.min[axis] : 0);
    }
    store<std::uint64_t>(at + 235, plan.extendedRecords > 0 ? plan.extendedOffset : 0);
    store<std::uint32_t>(at + 243, static_cast<std::uint32_t>(plan.extendedRecords));
    store<std::uint64_t>(at + 247, totals.points);
    for (std::size_t i = 0; i < totals.byReturn.size(); ++i)
        store<std::uint64_t>(at + 255 + 8 * i, totals.byReturn[i]);
    return bytes;
}

}  // namespace vestige
