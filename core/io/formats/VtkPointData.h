#pragma once

#include <string>
#include <vector>

#include "core/io/PointSink.h"
#include "core/io/formats/VtkValues.h"

namespace vestige {

/// The attributes of a legacy VTK file's points: normals, colours, intensity and time are kept by name and
/// kind, other arrays and those of cells are passed over.
class VtkPointData {
  public:
    VtkPointData(VtkValues& values, ReadJob& job) : values_(values), job_(job) {}

    /// At POINT_DATA or CELL_DATA, of a file with `points` points.
    void begin(bool ofPoints, std::size_t points);
    /// Reads the attribute section `key`; false when there is no such section.
    bool read(const std::string& key);

    /// Forgets the arrays that do not hold a value for each point, as the last of a file that ends early.
    void dropPartial(std::size_t points);
    /// The cloud of these coordinates (x, y, z after each other, all usable) with the attributes kept.
    PointCloud build(const std::vector<double>& coordinates) const;

  private:
    struct Array {
        std::string name;
        std::size_t components = 0;
        std::size_t tuples = 0;
        ScalarType type = ScalarType::float32;
    };
    void readScalars();
    void readFields();
    void readLookupTable();
    std::vector<double>* targetOf(const Array& array, const std::string& kind);
    void take(const Array& array, const std::string& kind);

    VtkValues& values_;
    ReadJob& job_;
    bool ofPoints_ = false;
    std::size_t count_ = 0;
    std::vector<double> normals_, colors_, intensity_, time_;
    ColorDepth colorDepth_ = ColorDepth::guess;
};

}  // namespace vestige
