#include "core/io/formats/PlyBody.h"

#include <algorithm>
#include <utility>

#include "core/base/CleanText.h"
#include "core/io/Coordinates.h"
#include "core/io/PointSink.h"
#include "core/io/Polygons.h"
#include "core/io/TextScanner.h"

namespace vestige {
namespace {

class AsciiValues {
  public:
    AsciiValues(std::string_view file, const PlyHeader& header, const ReadJob& job)
        : scanner_(file, header.bodyOffset, header.bodyLine), size_(file.size()), job_(job) {}

    double next(ScalarType) {
        if (const auto number = scanner_.nextNumber()) return *number;
        if (scanner_.atEnd())
            refuse("the file ends before its last value", "as many values as the header promises");
        refuse("a value is no number", "a number");
    }
    std::size_t remaining() const { return size_ - scanner_.offset() + 1; }
    /// The fewest bytes of a value: a digit and a blank.
    static std::size_t smallest(ScalarType) { return 2; }
    [[noreturn]] void refuse(std::string message, std::string expected) const {
        job_.refuseLine(scanner_.line(), std::move(message), std::move(expected));
    }

  private:
    TextScanner scanner_;
    std::size_t size_;
    const ReadJob& job_;
};

class BinaryValues {
  public:
    BinaryValues(std::string_view file, const PlyHeader& header, const ReadJob& job)
        : file_(file),
          at_(header.bodyOffset),
          order_(header.encoding == PlyEncoding::bigEndian ? std::endian::big : std::endian::little),
          job_(job) {}

    double next(ScalarType type) {
        const std::size_t size = sizeOf(type);
        if (remaining() < size)
            refuse("the file ends before its last value", "as many values as the header promises");
        const double value = readScalar(type, reinterpret_cast<const std::byte*>(file_.data()) + at_, order_);
        at_ += size;
        return value;
    }
    std::size_t remaining() const { return file_.size() - at_; }
    std::endian order() const { return order_; }
    const std::byte* here() const { return reinterpret_cast<const std::byte*>(file_.data()) + at_; }
    void skip(std::size_t bytes) { at_ += bytes; }
    static std::size_t smallest(ScalarType type) { return sizeOf(type); }
    [[noreturn]] void refuse(std::string message, std::string expected) const {
        job_.refuseByte(at_, std::move(message), std::move(expected));
    }

  private:
    std::string_view file_;
    std::size_t at_;
    std::endian order_;
    const ReadJob& job_;
};

template <class Values>
class BodyReader {
  public:
    BodyReader(std::string_view file, const PlyHeader& header, ReadJob& job)
        : values_(file, header, job), header_(header), job_(job) {}

    TriangleMesh read() {
        const auto vertex = std::find_if(header_.elements.begin(), header_.elements.end(),
                                         [](const PlyElement& element) { return element.name == "vertex"; });
        if (vertex == header_.elements.end())
            job_.refuseLine(header_.bodyLine - 1, "the header ends without points", "an element 'vertex'");
        vertexCount_ = vertex->count;
        PointSink sink = sinkFor(*vertex);
        Polygons polygons;
        const auto readAll = [&] {
            for (const PlyElement& element : header_.elements)
                orAsPromised(element, [&] {
                    if (&element == &*vertex)
                        readVertices(element, sink);
                    else if (element.name == "face")
                        readFaces(element, polygons);
                    else
                        skip(element);
                });
        };
        job_.untilDamage(readAll, [&] { return wholePart(*vertex, sink, polygons); });
        if (!job_.damage().empty()) polygons.dropBeyond(sink.size());
        if (polygons.skipped() > 0)
            job_.warn(counted(polygons.skipped(), "face") + " with fewer than three corners left out");
        TriangleMesh mesh{std::move(sink).build(), {}};
        mesh.triangles = std::move(polygons).triangles(mesh.vertices);
        return mesh;
    }

  private:
    PointSink sinkFor(const PlyElement& vertex) {
        std::vector<std::string> names;
        auto depth = ColorDepth::guess;
        for (const PlyProperty& property : vertex.properties) {
            names.push_back(property.list ? property.name + " (a list)" : property.name);
            if (fieldOfName(property.name) != PointField::red) continue;
            if (sizeOf(property.type) == 1) depth = ColorDepth::bytes;
            if (property.type == ScalarType::uint16) depth = ColorDepth::words;
        }
        return {fieldsOfNames(names, vertex.line, job_), depth};
    }

    WholePart wholePart(const PlyElement& vertex, const PointSink& sink, const Polygons& polygons) const {
        WholePart part{sink.size(), firstOf(sink.size(), vertex.count, "point")};
        for (const PlyElement& element : header_.elements)
            if (element.name == "face" && element.count > 0 && sink.size() == vertex.count)
                part.words += " and " + firstOf(polygons.faces(), element.count, "face");
        return part;
    }

    static std::size_t smallestSize(const PlyElement& element) {
        std::size_t smallest = 0;
        for (const PlyProperty& property : element.properties)
            smallest += Values::smallest(property.list ? property.lengthType : property.type);
        return smallest;
    }

    /// How many of the element's items the file can hold at most; not more than it promises.
    std::size_t possible(const PlyElement& element) const {
        return std::min<std::size_t>(element.count, values_.remaining() / smallestSize(element));
    }

    /// Reads an element. Where the file is too short for what the header promises, what there is is read
    /// before it is refused, for that might be salvaged.
    template <class Work>
    void orAsPromised(const PlyElement& element, const Work& work) {
        if (element.count == 0) return;
        if (smallestSize(element) == 0)
            job_.refuseLine(element.line, "the element has no properties", "a line 'property'");
        if (possible(element) == element.count) return work();
        const auto tooShort = [&, values = values_] {
            values.refuse("the header promises " + std::to_string(element.count) + " of element '" +
                              cleanText(element.name) + "', but the file ends too early for them",
                          "at least " + counted(smallestSize(element), "byte") + " for each, " +
                              std::to_string(values.remaining()) + " are left");
        };
        try {
            work();
        } catch (const ErrorException& thrown) {
            if (thrown.error.code == ErrorCode::input) tooShort();
            throw;
        }
        tooShort();
    }

    std::size_t listLength(const PlyProperty& property) {
        const double length = values_.next(property.lengthType);
        // Also catches what is no number.
        if (!(length >= 0 &&
              length <= static_cast<double>(values_.remaining() / Values::smallest(property.type))))
            values_.refuse("a list's length does not fit the file",
                           "a length from 0 to what the file still holds");
        return static_cast<std::size_t>(length);
    }

    void skip(const PlyProperty& property) {
        const std::size_t count = property.list ? listLength(property) : 1;
        for (std::size_t i = 0; i < count; ++i) values_.next(property.type);
    }

    void skip(const PlyElement& element) {
        job_.warn("not kept: element " + cleanText(element.name));
        for (std::size_t i = 0; i < element.count; ++i) {
            job_.step(i, element.count);
            for (const PlyProperty& property : element.properties) skip(property);
        }
    }

    void readVertices(const PlyElement& element, PointSink& sink) {
        std::vector<double> row(element.properties.size());
        if (readAtOnce(element, sink)) return;
        sink.reserve(possible(element));
        for (std::size_t i = 0; i < element.count; ++i) {
            job_.step(i, element.count);
            for (std::size_t k = 0; k < row.size(); ++k) {
                if (element.properties[k].list)
                    skip(element.properties[k]);
                else
                    row[k] = values_.next(element.properties[k].type);
            }
            if (!sink.add(row.data()))
                values_.refuse("vertex " + std::to_string(i + 1) + ": " + std::string(kUnusableCoordinate),
                               std::string(kUsableCoordinates));
        }
    }

    /// Binary points of a fixed size, all there: no need to go row by row.
    bool readAtOnce(const PlyElement& element, PointSink& sink) {
        if constexpr (std::is_same_v<Values, BinaryValues>) {
            RecordLayout layout;
            layout.order = values_.order();
            std::size_t stride = 0;
            for (const PlyProperty& property : element.properties) {
                if (property.list) return false;
                layout.columns.push_back({PointField::none, property.type, stride, 0});
                stride += sizeOf(property.type);
            }
            for (RecordColumn& column : layout.columns) column.step = stride;
            if (values_.remaining() / stride < element.count) return false;
            if (!sink.addRecords(values_.here(), element.count, std::move(layout), job_)) return false;
            values_.skip(element.count * stride);
            return true;
        }
        return false;
    }

    void readFaces(const PlyElement& element, Polygons& polygons) {
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < element.count; ++i) {
            job_.step(i, element.count);
            for (const PlyProperty& property : element.properties) {
                if (!property.list ||
                    (property.name != "vertex_indices" && property.name != "vertex_index")) {
                    skip(property);
                    continue;
                }
                corners.resize(listLength(property));
                for (std::uint32_t& corner : corners) {
                    const double index = values_.next(property.type);
                    if (!(index >= 0 && index < static_cast<double>(vertexCount_)))
                        values_.refuse("face " + std::to_string(i + 1) + " names a vertex that is not there",
                                       "an index from 0 to " + std::to_string(vertexCount_) + " - 1");
                    corner = static_cast<std::uint32_t>(index);
                }
                polygons.add(corners);
            }
        }
    }

    Values values_;
    const PlyHeader& header_;
    ReadJob& job_;
    std::uint64_t vertexCount_ = 0;
};

}  // namespace

TriangleMesh readPlyBody(std::string_view file, const PlyHeader& header, ReadJob& job) {
    if (header.encoding == PlyEncoding::ascii) return BodyReader<AsciiValues>(file, header, job).read();
    return BodyReader<BinaryValues>(file, header, job).read();
}

}  // namespace vestige
