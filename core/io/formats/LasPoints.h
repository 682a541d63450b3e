#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/geometry/PointCloudBuilder.h"
#include "core/io/FileInfo.h"
#include "core/io/formats/LasHeader.h"

namespace vestige {

/// One point as a record of any format holds it; what the format lacks is zero.
struct LasPoint {
    Eigen::Vector3d position;
    std::uint16_t intensity = 0;
    std::uint8_t returnNumber = 0;
    std::uint8_t returnCount = 0;
    std::uint8_t classification = 0;
    bool withheld = false;
    std::uint16_t pointSource = 0;
    double gpsTime = 0;
    Color color{};
};

using LasPointHandler = std::function<void(const LasPoint&)>;

/// Every point of an uncompressed file in order. The header has been checked against the file.
void readLasPoints(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job,
                   const LasPointHandler& handle);

/// Collects points as a cloud with the attributes of the header's point format.
class LasCloud {
  public:
    explicit LasCloud(const LasHeader& header) : layout_(lasPointLayout(header.pointFormat)) {}
    void reserve(std::size_t points) { builder_.reserve(points); }
    void add(const LasPoint& point);
    /// Colours that a writer left at 0 to 255 are spread to 16 bits, with a warning.
    PointCloud build(ReadJob& job) &&;

  private:
    const LasPointLayout& layout_;
    PointCloudBuilder builder_;
    std::size_t withheld_ = 0;
    std::uint16_t brightest_ = 0;
};

/// What `info` tells of the points, without keeping them.
class LasSummary {
  public:
    void add(const LasPoint& point);
    void describe(const LasHeader& header, FileInfo& info) const;

  private:
    std::uint64_t points_ = 0;
    BoundingBox bounds_;
    std::optional<std::pair<double, double>> timeSpan_;
};

}  // namespace vestige
