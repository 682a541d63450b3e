#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/PointCloud.h"
#include "core/io/FileInfo.h"
#include "core/io/ReadOptions.h"
#include "core/io/formats/LasHeader.h"

namespace vestige {

/// One point as a record of any format holds it; what the format lacks is zero.
struct LasPoint {
    std::array<std::int32_t, 3> steps{};  ///< of the header's scale, from its offset
    std::uint16_t intensity = 0;
    std::uint8_t returnNumber = 0;
    std::uint8_t returnCount = 0;
    std::uint8_t classification = 0;
    bool withheld = false;
    std::uint16_t pointSource = 0;
    Color color{};
    double gpsTime = 0;
};

/// The world coordinates of a point's steps: what the LAS specification says, in double.
inline Eigen::Vector3d lasPosition(const LasHeader& header, const std::array<std::int32_t, 3>& steps) {
    return {steps[0] * header.scale.x() + header.offset.x(), steps[1] * header.scale.y() + header.offset.y(),
            steps[2] * header.scale.z() + header.offset.z()};
}

/// Points `first`, `first` + 1, ... of the file, a few hundred at a time.
using LasBlockHandler = std::function<void(std::uint64_t first, std::span<const LasPoint> points)>;

/// The points [begin, end) of an uncompressed file. The header has been checked against the file.
void readLasPoints(std::span<const std::byte> file, const LasHeader& header, std::uint64_t begin,
                   std::uint64_t end, const LasBlockHandler& handle);

/// Collects points as a cloud with the attributes of the header's point format. Many threads may fill it.
class LasCloud {
  public:
    LasCloud(const LasHeader& header, ReadOptions::Attributes attributes);
    /// For set() at the places below `points`.
    void resize(std::size_t points);
    void set(std::size_t place, const LasPoint& point);
    /// What parts of the file found out on their way, each told once.
    void note(std::uint64_t withheld, std::uint16_t brightest);

    /// Offsets round the middle of the points, exact on the file's grid; residuals only where floats cannot
    /// tell its steps. Colours that a writer left at 0 to 255 are spread to 16 bits, with a warning.
    PointCloud build(ReadJob& job) &&;

  private:
    struct Reach {
        std::array<std::int32_t, 3> least;
        std::array<std::int32_t, 3> most;
    };
    Reach reach() const;

    const LasHeader& header_;
    const LasPointLayout& layout_;
    bool all_;
    LargeArray<Eigen::Vector3f>
        steps_;  ///< the bits of three integers until build(), which needs no more memory
    LargeArray<std::uint16_t> intensity_;
    PointAttributes attributes_;
    std::uint64_t withheld_ = 0;
    std::uint16_t brightest_ = 0;
};

/// What `info` tells of the points, without keeping them.
class LasSummary {
  public:
    void add(const LasHeader& header, const LasPoint& point);
    void add(const LasSummary& other);
    void describe(const LasHeader& header, FileInfo& info) const;

  private:
    std::uint64_t points_ = 0;
    BoundingBox bounds_;
    std::optional<std::pair<double, double>> timeSpan_;
};

/// The attributes that points of this format have, as FileInfo names them.
std::vector<std::string> lasAttributes(const LasPointLayout& layout, bool timed);

}  // namespace vestige
