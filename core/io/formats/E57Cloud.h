#pragma once

#include "core/geometry/PointCloudBuilder.h"
#include "core/io/ReadOptions.h"
#include "core/io/formats/E57Rows.h"

namespace vestige {

/// The attributes that any of the scans has: points of the others get zeros, and no time.
struct E57Attributes {
    bool intensity = false, color = false, classification = false, time = false, normal = false;
    bool source = false, returnNumber = false, returnCount = false;

    explicit E57Attributes(const E57Document& document);
    void leaveUndrawn() { time = source = returnNumber = returnCount = false; }
    /// As FileInfo names them.
    std::vector<std::string> names() const;
};

/// Collects the points of decoded records, scan after scan, as far as the options want them.
class E57Cloud {
  public:
    E57Cloud(const E57Document& document, const ReadOptions& options);

    void reserve(std::size_t points);
    void beginScan(std::size_t place);
    void add(const E57Rows& rows);
    /// Returns how many points of the scan had a position, wanted or not.
    std::uint64_t endScan(ReadJob& job);
    /// Leaves it empty; what was left out is warned of.
    PointCloud build(ReadJob& job) &&;

  private:
    void addAttributes(const E57Rows& rows, std::size_t i);
    void seeReturn(const E57Rows& rows, std::size_t i);

    const ReadOptions& options_;
    E57Attributes attributes_;
    bool severalScans_;
    PointCloudBuilder builder_;
    std::uint16_t number_ = 0;
    std::size_t firstOfScan_ = 0;
    std::uint64_t ofScan_ = 0, met_ = 0;
    std::size_t invalid_ = 0, notFinite_ = 0;
    double leastReturn_ = 0;
    bool returnIsCount_ = false;
};

}  // namespace vestige
