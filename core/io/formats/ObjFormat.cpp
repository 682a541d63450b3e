#include "core/io/formats/ObjFormat.h"

#include <optional>

#include "core/io/Coordinates.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/PointSink.h"
#include "core/io/Polygons.h"
#include "core/io/TextScanner.h"

namespace vestige {
namespace {

/// Vertices (in double), their colours, normals and faces of all groups; curves and materials are passed
/// over.
class ObjReader {
  public:
    ObjReader(std::string_view text, ReadJob& job) : scanner_(text), size_(text.size()), job_(job) {}

    TriangleMesh read() {
        job_.untilDamage([&] { readLines(); },
                         [&] {
                             return WholePart{vertices_.size(),
                                              "the first " + counted(vertices_.size(), "point") + " and " +
                                                  counted(polygons_.faces(), "face")};
                         });
        if (!job_.damage().empty()) polygons_.dropBeyond(vertices_.size());
        return build();
    }

  private:
    void readLines() {
        while (!scanner_.atEnd()) {
            line_ = scanner_.line();
            if ((line_ & 0xffff) == 0) job_.report(scanner_.offset(), size_);
            readLine(scanner_.nextLine());
        }
        if (vertices_.empty()) job_.refuseLine(line_, "the file has no vertices", "lines 'v x y z'");
        if (largestCorner_ >= vertices_.size())
            job_.refuseLine(largestLine_, "a face names vertex " + std::to_string(largestCorner_ + 1),
                            "a vertex of the file's " + std::to_string(vertices_.size()));
    }

    void readLine(std::string_view line) {
        const std::string_view keyword = takeToken(line);
        if (keyword == "v")
            readVertex(line);
        else if (keyword == "vn")
            readNormal(line);
        else if (keyword == "f")
            readFace(line);
    }

    double number(std::string_view& line, std::string_view expected) const {
        const std::string_view token = takeToken(line);
        const char* at = token.data();
        const auto value = takeNumber(at, token.data() + token.size());
        if (!value || at != token.data() + token.size())
            job_.refuseLine(line_, "a value is missing or no number", std::string(expected));
        return *value;
    }

    void readVertex(std::string_view line) {
        Vertex vertex;
        for (double& coordinate : vertex.position) coordinate = number(line, "v x y z");
        if (!isUsable(vertex.position))
            job_.refuseLine(line_, std::string(kUnusableCoordinate), std::string(kUsableCoordinates));
        std::vector<double> more;
        while (!trimmed(line).empty() && more.size() < 4) more.push_back(number(line, "v x y z [r g b]"));
        // x y z r g b, or x y z w r g b; a lone w weighs curves and moves no vertex.
        if (more.size() >= 3) {
            vertex.color = {more[more.size() - 3], more[more.size() - 2], more[more.size() - 1]};
            ++colored_;
        }
        vertices_.push_back(vertex);
    }

    void readNormal(std::string_view line) {
        Eigen::Vector3d normal;
        for (double& coordinate : normal) coordinate = number(line, "vn x y z");
        normals_.push_back(normal);
    }

    /// An index of the file: from 1, or negative from the end of what was read so far.
    std::size_t index(const char*& at, const char* end, std::size_t known) const {
        const auto value = takeNumber(at, end);
        if (!value || *value != std::floor(*value) || *value == 0 || *value > 4294967295.0 ||
            *value < -static_cast<double>(known))
            job_.refuseLine(line_, "a face names a vertex or normal that is not there",
                            "whole numbers from 1, or from -1 down to what was read before");
        return *value > 0 ? static_cast<std::size_t>(*value) - 1 : known - static_cast<std::size_t>(-*value);
    }

    void readFace(std::string_view line) {
        corners_.clear();
        for (auto token = takeToken(line); !token.empty(); token = takeToken(line)) {
            const char* at = token.data();
            const char* end = at + token.size();
            const std::size_t vertex = index(at, end, vertices_.size());
            if (vertex >= largestCorner_) {
                largestCorner_ = vertex;
                largestLine_ = line_;
            }
            corners_.push_back(static_cast<std::uint32_t>(vertex));
            const std::size_t slash = token.rfind('/');
            const bool hasNormal =
                slash != std::string_view::npos && token.find('/') != slash && slash + 1 < token.size();
            at = hasNormal ? token.data() + slash + 1 : at;
            const bool sameNormal = hasNormal && index(at, end, normals_.size()) == vertex;
            normalPerVertex_ = normalPerVertex_ && sameNormal;
        }
        if (corners_.size() < 3)
            job_.refuseLine(line_, "a face has " + std::to_string(corners_.size()) + " corners",
                            "three or more");
        polygons_.add(corners_);
    }

    TriangleMesh build() {
        using enum PointField;
        const bool colored = colored_ == vertices_.size();
        const bool normals = normalPerVertex_ && normals_.size() == vertices_.size();
        if (colored_ > 0 && !colored) job_.warn("colours not kept: not every vertex has one");
        if (!normals_.empty() && !normals)
            job_.warn("normals not kept: they belong to corners, not to vertices");
        std::vector<PointField> fields{x, y, z};
        if (colored) fields.insert(fields.end(), {red, green, blue});
        if (normals) fields.insert(fields.end(), {normalX, normalY, normalZ});
        PointSink sink(fields, ColorDepth::guess);
        sink.reserve(vertices_.size());
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const auto& [position, color] = vertices_[i];
            std::vector<double> row{position.x(), position.y(), position.z()};
            if (colored) row.insert(row.end(), color.begin(), color.end());
            if (normals) row.insert(row.end(), normals_[i].begin(), normals_[i].end());
            sink.add(row.data());
        }
        TriangleMesh mesh{std::move(sink).build(), {}};
        mesh.triangles = std::move(polygons_).triangles(mesh.vertices);
        return mesh;
    }

    struct Vertex {
        Eigen::Vector3d position;
        std::array<double, 3> color{};
    };

    TextScanner scanner_;
    std::size_t size_;
    ReadJob& job_;
    std::size_t line_ = 1;
    std::vector<Vertex> vertices_;
    std::vector<Eigen::Vector3d> normals_;
    std::size_t colored_ = 0;
    bool normalPerVertex_ = true;
    Polygons polygons_;
    std::vector<std::uint32_t> corners_;
    std::size_t largestCorner_ = 0;
    std::size_t largestLine_ = 1;
};

}  // namespace

bool ObjFormat::recognises(std::span<const std::byte>, std::string_view) const {
    return false;  // OBJ has no signature; the extension says so
}

Result<LoadedGeometry> ObjFormat::read(const std::filesystem::path& file, const ReadOptions& options,
                                       const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control, options.salvage);
        TriangleMesh mesh = ObjReader(content->text(), job).read();
        return loaded(std::move(mesh), "OBJ", "", job);
    });
}

}  // namespace vestige
