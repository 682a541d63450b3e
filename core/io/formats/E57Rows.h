#pragma once

#include <array>
#include <vector>

#include "core/io/FieldValues.h"
#include "core/io/formats/E57Streams.h"

namespace vestige {

/// Some records of a scan, decoded, and what they mean: points in the file's frame.
class E57Rows {
  public:
    /// `drawnOnly`: without the attributes that nothing draws.
    E57Rows(const E57Scan& scan, bool drawnOnly);
    /// Decodes `count` records from `first` on, in place of those before.
    void decode(const E57Streams& streams, std::uint64_t first, std::size_t count);
    /// Refuses where a page that decode() would touch is damaged.
    void check(const E57Streams& streams, std::uint64_t first, std::uint64_t count, const ReadJob& job) const;

    std::size_t size() const { return size_; }
    /// Whether the record has a position; not where the scanner got no echo.
    bool valid(std::size_t i) const;
    /// In the file's frame; not finite where the record is not.
    Eigen::Vector3d point(std::size_t i) const;

    bool has(E57Role role) const { return !columns_[index(role)].empty(); }
    double value(E57Role role, std::size_t i) const { return columns_[index(role)][i]; }
    /// The value as the nearest integer within 0 to the type's largest; 0 where it is no number.
    template <class Number>
    Number whole(E57Role role, std::size_t i, double plus = 0) const {
        return nearestInteger<Number>(value(role, i) + plus);
    }
    float intensity(std::size_t i) const;         ///< as in the file; 0 where it is invalid
    Color color(std::size_t i) const;             ///< the limits spread to 16 bits; black where invalid
    double time(std::size_t i) const;             ///< see E57Scan::timeStart; NaN where it is invalid
    Eigen::Vector3f normal(std::size_t i) const;  ///< in the file's frame
    bool hasColor() const { return has(E57Role::red) && has(E57Role::green) && has(E57Role::blue); }
    bool hasNormal() const { return has(E57Role::normalX) && has(E57Role::normalY) && has(E57Role::normalZ); }

  private:
    static std::size_t index(E57Role role) { return static_cast<std::size_t>(role); }
    bool flagged(E57Role role, std::size_t i) const { return has(role) && value(role, i) != 0; }

    const E57Scan& scan_;
    std::vector<E57Role> wanted_;
    bool cartesian_ = true;
    double timeOffset_ = 0;
    std::size_t size_ = 0;
    std::array<std::vector<double>, static_cast<std::size_t>(E57Role::count)> columns_;
    std::vector<std::byte> bytes_;
};

}  // namespace vestige
