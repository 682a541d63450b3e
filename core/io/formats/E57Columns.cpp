#include "core/io/formats/E57Columns.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/Numbers.h"
#include "core/io/PointColumns.h"
#include "core/io/formats/E57Time.h"

namespace vestige {
namespace {

/// Integers up to here are exact as double.
constexpr double kExact = 9007199254740992.0;
/// Intensities that are whole numbers up to here are written as such.
constexpr float kMostIntensity = 16777216;

E57Column realColumn(std::string element, std::function<double(std::size_t)> value) {
    return {std::move(element), "type=\"Float\"", "", 64,
            [value = std::move(value)](std::size_t i) { return std::bit_cast<std::uint64_t>(value(i)); }};
}

E57Column singleColumn(std::string element, std::function<float(std::size_t)> value) {
    return {std::move(element), "type=\"Float\" precision=\"single\"", "", 32,
            [value = std::move(value)](std::size_t i) {
                return std::uint64_t{std::bit_cast<std::uint32_t>(value(i))};
            }};
}

std::string limits(std::int64_t minimum, std::int64_t maximum) {
    return " minimum=\"" + std::to_string(minimum) + "\" maximum=\"" + std::to_string(maximum) + "\"";
}

E57Column integerColumn(std::string element, std::int64_t minimum, std::int64_t maximum,
                        std::function<std::int64_t(std::size_t)> value) {
    // A range of one value would take no bits, which not every reader knows.
    maximum = std::max(maximum, minimum + 1);
    return {std::move(element), "type=\"Integer\"" + limits(minimum, maximum), std::to_string(minimum),
            static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(maximum - minimum))),
            [value = std::move(value), minimum](std::size_t i) {
                return static_cast<std::uint64_t>(value(i) - minimum);
            }};
}

class PartBuilder {
  public:
    PartBuilder(const PointCloud& cloud, const FileInfo* source, E57Part& part)
        : cloud_(cloud), attributes_(cloud.attributes()), source_(source), part_(part) {}

    void build(bool sourceIsScan) {
        addCoordinates();
        addIntensity();
        addColors();
        addTimes();
        addNormals();
        addReturnIndex();
        addWhole("returnCount", attributes_.returnCount);
        addWhole("las:classification", attributes_.classification);
        if (!sourceIsScan) addWhole("las:pointSourceId", attributes_.pointSource);
    }

  private:
    template <class Values>
    void addWhole(const char* element, const Values& values) {
        if (values.empty()) return;
        std::int64_t largest = 1;
        for (std::size_t k = 0; k < part_.points; ++k)
            largest = std::max<std::int64_t>(largest, values[part_.member(k)]);
        part_.columns.push_back(
            integerColumn(element, 0, largest, [&values](std::size_t i) { return std::int64_t{values[i]}; }));
    }

    /// From 0, where Vestige and LAS count from 1; -1 for the 0 of a point of no return.
    void addReturnIndex() {
        const auto& numbers = attributes_.returnNumber;
        if (numbers.empty()) return;
        int least = 1;
        int largest = 1;
        for (std::size_t k = 0; k < part_.points; ++k) {
            least = std::min<int>(least, numbers[part_.member(k)]);
            largest = std::max<int>(largest, numbers[part_.member(k)]);
        }
        part_.columns.push_back(
            integerColumn("returnIndex", least - 1, largest - 1,
                          [&numbers](std::size_t i) { return std::int64_t{numbers[i]} - 1; }));
    }

    void addCoordinates() {
        const Pose scanFromFile = part_.info.fileFromScan.inverse();
        const bool moved = part_.info.fileFromScan.matrix() != Eigen::Matrix4d::Identity();
        const SourceGrid grid(moved ? nullptr : source_);
        const auto point = [&cloud = cloud_, scanFromFile, moved, grid](std::size_t i) -> Eigen::Vector3d {
            return moved ? scanFromFile * cloud.point(i) : grid(cloud.point(i));
        };
        for (std::size_t k = 0; k < part_.points; ++k) part_.bounds.add(point(part_.member(k)));
        const std::vector<E57Column> scaled = moved ? std::vector<E57Column>{} : gridColumns();
        if (!scaled.empty()) {
            part_.columns = scaled;
            return;
        }
        constexpr std::array kNames{"cartesianX", "cartesianY", "cartesianZ"};
        for (int axis = 0; axis < 3; ++axis)
            part_.columns.push_back(realColumn(kNames[static_cast<std::size_t>(axis)],
                                               [point, axis](std::size_t i) { return point(i)[axis]; }));
    }

    /// Integers on the source's grid; nothing where it has none or a point is off it.
    std::vector<E57Column> gridColumns() const {
        if (!source_ || !source_->scale || !(source_->scale->array() > 0).all() || part_.bounds.empty())
            return {};
        const Eigen::Vector3d scale = *source_->scale;
        const Eigen::Vector3d offset = source_->offset.value_or(Eigen::Vector3d::Zero());
        const SourceGrid grid(source_);
        const auto step = [scale, offset](const Eigen::Vector3d& point, int axis) {
            return std::round((point[axis] - offset[axis]) / scale[axis]);
        };
        for (std::size_t k = 0; k < part_.points; ++k) {
            const std::size_t i = part_.member(k);
            const Eigen::Vector3d point = grid(cloud_.point(i));
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(step(point, axis)) < kExact / 4) ||
                    step(point, axis) * scale[axis] + offset[axis] != point[axis])
                    return {};
        }
        std::vector<E57Column> columns;
        constexpr std::array kNames{"cartesianX", "cartesianY", "cartesianZ"};
        for (int axis = 0; axis < 3; ++axis) {
            E57Column& column = columns.emplace_back(
                integerColumn(kNames[static_cast<std::size_t>(axis)],
                              static_cast<std::int64_t>(step(part_.bounds.min, axis)),
                              static_cast<std::int64_t>(step(part_.bounds.max, axis)),
                              [&cloud = cloud_, grid, step, axis](std::size_t i) {
                                  return static_cast<std::int64_t>(step(grid(cloud.point(i)), axis));
                              }));
            column.attributes.replace(0, 14, "type=\"ScaledInteger\"");
            column.attributes +=
                " scale=\"" + exactText(scale[axis]) + "\" offset=\"" + exactText(offset[axis]) + "\"";
        }
        return columns;
    }

    void addIntensity() {
        const auto& values = attributes_.intensity;
        if (values.empty()) return;
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        bool whole = true;
        for (std::size_t k = 0; k < part_.points; ++k) {
            const std::size_t i = part_.member(k);
            const float value = values[i];
            whole = whole && std::abs(value) <= kMostIntensity && value == std::trunc(value) &&
                    !(value == 0 && std::signbit(value));
            if (!std::isfinite(value)) continue;
            low = std::min<double>(low, value);
            high = std::max<double>(high, value);
        }
        if (low > high) low = high = 0;
        part_.intensityLimits.emplace(low, high);
        part_.intensityIsInteger = whole;
        if (whole)
            part_.columns.push_back(
                integerColumn("intensity", static_cast<std::int64_t>(low), static_cast<std::int64_t>(high),
                              [&values](std::size_t i) { return static_cast<std::int64_t>(values[i]); }));
        else
            part_.columns.push_back(
                singleColumn("intensity", [&values](std::size_t i) { return values[i]; }));
    }

    void addColors() {
        if (attributes_.color.empty()) return;
        const bool bytes = colorsAreBytes(cloud_);
        part_.colorMaximum = bytes ? 255 : 65535;
        constexpr std::array kNames{"colorRed", "colorGreen", "colorBlue"};
        for (std::size_t channel = 0; channel < 3; ++channel)
            part_.columns.push_back(integerColumn(
                kNames[channel], 0, part_.colorMaximum,
                [&colors = attributes_.color, channel, divisor = bytes ? 257 : 1](std::size_t i) {
                    return std::int64_t{colors[i][channel] / divisor};
                }));
    }

    void addTimes() {
        const auto& times = attributes_.gpsTime;
        if (times.empty()) return;
        part_.timeStart = source_ && source_->gpsTimeIsAdjustedStandard ? kAdjustedStandard : 0;
        part_.columns.push_back(realColumn(
            "timeStamp", [&times](std::size_t i) { return std::isfinite(times[i]) ? times[i] : 0; }));
        bool whole = true;
        for (std::size_t k = 0; k < part_.points; ++k) whole = whole && std::isfinite(times[part_.member(k)]);
        if (!whole)
            part_.columns.push_back(integerColumn("isTimeStampInvalid", 0, 1, [&times](std::size_t i) {
                return std::int64_t{std::isfinite(times[i]) ? 0 : 1};
            }));
    }

    void addNormals() {
        if (attributes_.normal.empty()) return;
        const Eigen::Matrix3f scanFromFile = part_.info.fileFromScan.linear().transpose().cast<float>();
        constexpr std::array kNames{"nor:normalX", "nor:normalY", "nor:normalZ"};
        for (int axis = 0; axis < 3; ++axis)
            part_.columns.push_back(
                singleColumn(kNames[static_cast<std::size_t>(axis)],
                             [&normals = attributes_.normal, scanFromFile, axis](std::size_t i) {
                                 return scanFromFile.row(axis).dot(normals[i]);
                             }));
    }

    const PointCloud& cloud_;
    const PointAttributes& attributes_;
    const FileInfo* source_;
    E57Part& part_;
};

/// Whether the points' sources are the numbers of the source's scans.
bool sourcesAreScans(const PointCloud& cloud, const FileInfo* source) {
    const auto& numbers = cloud.attributes().pointSource;
    return source && source->scans.size() > 1 && !numbers.empty() &&
           std::all_of(numbers.begin(), numbers.end(),
                       [&](std::uint16_t number) { return number >= 1 && number <= source->scans.size(); });
}

}  // namespace

std::vector<E57Part> e57Parts(const PointCloud& cloud, const FileInfo* source) {
    const bool split = sourcesAreScans(cloud, source);
    std::vector<E57Part> parts(split ? source->scans.size() : 1);
    if (split)
        for (std::size_t i = 0; i < cloud.size(); ++i)
            parts[cloud.attributes().pointSource[i] - std::size_t{1}].members.push_back(
                static_cast<std::uint32_t>(i));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].points = split ? parts[i].members.size() : cloud.size();
        if (source && source->scans.size() == parts.size()) parts[i].info = source->scans[i];
        PartBuilder(cloud, source, parts[i]).build(split);
    }
    return parts;
}

}  // namespace vestige
