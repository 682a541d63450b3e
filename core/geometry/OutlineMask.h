#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace vestige {

/// The pixels of a picture whose centres lie within a closed outline, by the even-odd rule. Pixels right and
/// down from the top left corner; what lies outside of the picture is not within.
class OutlineMask {
  public:
    enum class Cover { none, part, all };

    /// `corners` in pixels, in order; the last is joined to the first. Fewer than three enclose nothing.
    OutlineMask(std::span<const Eigen::Vector2d> corners, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return count(0, 0, width_, height_) == 0; }
    /// Of the pixel that the place falls into.
    bool contains(double x, double y) const {
        if (!(x >= 0 && y >= 0 && x < width_ && y < height_)) return false;
        const int column = static_cast<int>(x);
        const int row = static_cast<int>(y);
        return count(column, row, column + 1, row + 1) > 0;
    }
    /// Of all places from `least` to `most`.
    Cover cover(const Eigen::Vector2d& least, const Eigen::Vector2d& most) const;

  private:
    void fillRows(std::span<const Eigen::Vector2d> corners);
    /// Pixels within, of the columns [x0, x1) and rows [y0, y1).
    std::uint32_t count(int x0, int y0, int x1, int y1) const {
        return sum(x1, y1) - sum(x0, y1) - sum(x1, y0) + sum(x0, y0);
    }
    std::uint32_t sum(int x, int y) const {
        return sums_[static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1) +
                     static_cast<std::size_t>(x)];
    }

    int width_;
    int height_;
    std::vector<std::uint32_t> sums_;  ///< pixels within, left of and above each corner of the raster
};

}  // namespace vestige
