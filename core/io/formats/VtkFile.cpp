#include "core/io/formats/VtkFile.h"

#include "core/io/formats/VtkCells.h"
#include "core/io/formats/VtkPointData.h"

namespace vestige {
namespace {

class VtkReader {
  public:
    VtkReader(std::string_view file, ReadJob& job)
        : values_(file, job), cells_(values_, job), data_(values_, job), job_(job) {}

    VtkContent read() {
        VtkContent content;
        content.version = readHead();
        for (std::string key = values_.keyword(); !key.empty(); key = values_.keyword()) readSection(key);
        if (!havePoints_) values_.refuse("the file lists no points", "a line POINTS");
        content.mesh.vertices = data_.build(coordinates_);
        content.mesh.triangles = cells_.triangles(content.mesh.vertices);
        return content;
    }

  private:
    std::string readHead() {
        constexpr std::string_view kFirst = "# vtk DataFile Version ";
        const std::string_view first = values_.nextLine();
        if (!first.starts_with(kFirst))
            values_.refuse("this is no legacy VTK file", std::string(kFirst) + "3.0");
        values_.nextLine();  // title
        const std::string encoding = values_.keyword();
        if (encoding != "ASCII" && encoding != "BINARY")
            values_.refuse("the encoding is unknown", "ASCII or BINARY");
        if (values_.keyword() != "DATASET") values_.refuse("the line DATASET is missing", "DATASET POLYDATA");
        values_.word();
        values_.setBinary(encoding == "BINARY");
        return printable(trimmed(first.substr(kFirst.size())).substr(0, 8)) +
               (values_.binary() ? ", binary" : ", ascii");
    }

    void readSection(const std::string& key) {
        if (key == "POINTS")
            readPoints();
        else if (VtkCells::isSection(key))
            cells_.read(key, points());
        else if (key == "CELL_TYPES")
            cells_.readTypes(points());
        else if (key == "POINT_DATA" || key == "CELL_DATA")
            data_.begin(key == "POINT_DATA", points());
        else if (key == "DIMENSIONS")
            values_.nextLine();
        else if (key == "METADATA")
            values_.skipMetadata();
        else if (!data_.read(key))
            values_.refuse("the section '" + printable(key) + "' is unknown",
                           "POINTS, POLYGONS, POINT_DATA and such");
    }

    void readPoints() {
        if (havePoints_) values_.refuse("points are listed twice", "one section POINTS");
        const std::size_t count = values_.count();
        const ScalarType type = values_.type();
        values_.beginArray(3 * count, type);
        coordinates_.resize(3 * count);
        for (std::size_t i = 0; i < coordinates_.size(); ++i) {
            job_.step(i, coordinates_.size());
            coordinates_[i] = values_.value(type);
        }
        havePoints_ = true;
    }

    std::size_t points() const { return coordinates_.size() / 3; }

    VtkValues values_;
    VtkCells cells_;
    VtkPointData data_;
    ReadJob& job_;
    bool havePoints_ = false;
    std::vector<double> coordinates_;
};

}  // namespace

VtkContent readVtk(std::string_view file, ReadJob& job) {
    return VtkReader(file, job).read();
}

}  // namespace vestige
