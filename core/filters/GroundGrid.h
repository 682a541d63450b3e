#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace vestige {

/// Heights over the squares of a grid; not-a-number where there is none. Row after row.
class GroundGrid {
  public:
    GroundGrid(const Eigen::Vector2f& corner, float cell, int columns, int rows);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    float cell() const { return cell_; }
    std::size_t size() const { return heights.size(); }
    /// The square that a place falls into; places outside of the grid are put at its edge.
    std::size_t index(float x, float y) const;
    /// Its middle.
    Eigen::Vector2f centre(std::size_t index) const;

    std::vector<float> heights;

  private:
    Eigen::Vector2f corner_;
    float cell_;
    int columns_;
    int rows_;
};

/// Grey opening with a square of 2 radius + 1 cells: the greatest of the least heights of all squares that
/// hold a cell. What is empty takes no part. By running minima (van Herk 1992), so that its time does not
/// depend on the radius.
void openHeights(std::vector<float>& heights, int columns, int rows, int radius);

/// Fills what is empty from what lies round it: means over squares twice as large each time, handed down.
void fillHeights(std::vector<float>& heights, int columns, int rows);

}  // namespace vestige
