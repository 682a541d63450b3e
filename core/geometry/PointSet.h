#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace vestige {

/// A set of point indices of one cloud, held as runs of consecutive ones. Immutable once made.
class PointSet {
  public:
    /// Indices from first to before last; runs are ascending, apart from each other and not empty.
    using Run = std::pair<std::uint32_t, std::uint32_t>;

    PointSet() = default;
    /// `indices` in ascending order, each once.
    static PointSet fromSorted(std::span<const std::uint32_t> indices);
    static PointSet fromRuns(std::vector<Run> runs);

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::span<const Run> runs() const { return runs_; }
    bool contains(std::uint32_t index) const;
    std::vector<std::uint32_t> indices() const;
    PointSet unitedWith(const PointSet& other) const;
    PointSet without(const PointSet& other) const;
    /// The indices from 0 to before `count` that are not in it.
    PointSet complement(std::uint32_t count) const;

    friend bool operator==(const PointSet&, const PointSet&) = default;

  private:
    std::vector<Run> runs_;
    std::size_t size_ = 0;
};

}  // namespace vestige
