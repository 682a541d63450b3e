#include "core/io/formats/VtkFile.h"

#include "core/base/CleanText.h"
#include "core/io/Coordinates.h"
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
        const auto readAll = [&] {
            for (std::string key = values_.keyword(); !key.empty(); key = values_.keyword()) readSection(key);
            if (!havePoints_) values_.refuse("the file lists no points", "a line POINTS");
        };
        job_.untilDamage(readAll, [&] { return WholePart{points(), firstOf(points(), promised_, "point")}; });
        if (!job_.damage().empty()) data_.dropPartial(points());
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
        return cleanText(trimmed(first.substr(kFirst.size())).substr(0, 8)) +
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
            values_.refuse("the section '" + cleanText(key) + "' is unknown",
                           "POINTS, POLYGONS, POINT_DATA and such");
    }

    void readPoints() {
        if (havePoints_) values_.refuse("points are listed twice", "one section POINTS");
        promised_ = values_.count(0);
        values_.checkProduct(promised_, 3);
        const ScalarType type = values_.type();
        const VtkValues start = values_;
        const std::size_t there = values_.beginCutArray(promised_, 3, type);
        // What there is of a file that is too short is read before it is refused: it might be salvaged.
        const auto refuseTooShort = [&] {
            start.refuse("the file ends before its " + counted(promised_, "point"), "a file that is whole");
        };
        coordinates_.reserve(3 * there);
        try {
            for (std::size_t i = 0; i < there; ++i) {
                job_.step(i, there);
                readPoint(i, type);
            }
        } catch (const ErrorException& thrown) {
            if (there < promised_ && thrown.error.code == ErrorCode::input) refuseTooShort();
            throw;
        }
        if (there < promised_) refuseTooShort();
        havePoints_ = true;
    }

    void readPoint(std::size_t number, ScalarType type) {
        Eigen::Vector3d point;
        for (double& coordinate : point) coordinate = values_.value(type);
        if (!isUsable(point))
            values_.refuse("point " + std::to_string(number + 1) + ": " + std::string(kUnusableCoordinate),
                           std::string(kUsableCoordinates));
        coordinates_.insert(coordinates_.end(), point.begin(), point.end());
    }

    std::size_t points() const { return coordinates_.size() / 3; }

    VtkValues values_;
    VtkCells cells_;
    VtkPointData data_;
    ReadJob& job_;
    bool havePoints_ = false;
    std::size_t promised_ = 0;
    std::vector<double> coordinates_;
};

}  // namespace

VtkContent readVtk(std::string_view file, ReadJob& job) {
    return VtkReader(file, job).read();
}

}  // namespace vestige
