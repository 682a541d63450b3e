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

/// Takes `count` records of an uncompressed file, the first of which is point `first`, apart.
void decodeLasRecords(const std::byte* records, std::size_t count, const LasHeader& header,
                      std::uint64_t first, const LasBlockHandler& handle);

/// What some points of a file were found to be while they were read.
struct LasNotes {
    std::uint64_t points = 0;
    std::uint64_t withheld = 0;
    std::uint16_t brightest = 0;
    std::array<std::int32_t, 3> least{};  ///< steps; of no points zero
    std::array<std::int32_t, 3> most{};

    void add(const LasPoint& point);
    void add(const LasNotes& other);
};

/// Collects points as a cloud with the attributes of the header's point format. Many threads may fill it.
class LasCloud {
  public:
    /// Offsets round `origin`; residuals beside them where `exact`, for points that floats cannot tell.
    LasCloud(const LasHeader& header, ReadOptions::Attributes attributes, const Eigen::Vector3d& origin,
             bool exact);
    /// For set() at the places below `points`.
    void resize(std::size_t points);
    void set(std::size_t place, const LasPoint& point);
    /// The same for `count` records as an uncompressed file has them; only for Attributes::drawn.
    void setRecords(std::size_t place, const std::byte* records, std::size_t count, LasNotes& notes);

    /// Whether each point can be told from its offset (or its residual).
    bool holds(const LasNotes& notes) const;
    /// Exact on the file's grid. Colours that a writer left at 0 to 255 are spread to 16 bits, with a
    /// warning.
    PointCloud build(const LasNotes& notes, ReadJob& job) &&;

  private:
    template <bool kColor>
    void setDrawn(std::size_t place, const std::byte* records, std::size_t count, LasNotes& notes);

    const LasHeader& header_;
    const LasPointLayout& layout_;
    bool all_;
    Eigen::Vector3d origin_;
    bool exact_;
    LargeArray<Eigen::Vector3f> offsets_;
    LargeArray<Eigen::Vector3f> residuals_;
    LargeArray<std::uint16_t> intensity_;
    PointAttributes attributes_;
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
