#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/io/Polygons.h"
#include "core/io/formats/VtkValues.h"

namespace vestige {

/// Collects the polygons of a legacy VTK file: POLYGONS of poly data, cells of type triangle, quad and
/// polygon of unstructured grids; both the layout of versions to 4 and that of version 5.
class VtkCells {
  public:
    VtkCells(VtkValues& values, ReadJob& job) : values_(values), job_(job) {}

    static bool isSection(const std::string& key);
    /// Reads the section `key`; corners must be below `points`.
    void read(const std::string& key, std::size_t points);
    void readTypes(std::size_t points);

    std::vector<Triangle> triangles(const PointCloud& vertices) {
        return std::move(polygons_).triangles(vertices);
    }

  private:
    using Corners = std::vector<double>;
    void add(const Corners& corners);
    void readJoined(std::size_t cells, std::size_t numbers);
    void readSplit(std::size_t offsets, std::size_t connections);
    void take();

    VtkValues& values_;
    ReadJob& job_;
    std::size_t points_ = 0;
    std::string section_;
    Corners corners_;
    Polygons polygons_;
    // An unstructured grid says later, in CELL_TYPES, which of its cells are polygons.
    std::vector<std::size_t> gridLengths_;
    Corners gridCorners_;
};

}  // namespace vestige
