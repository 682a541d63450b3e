#include "core/io/formats/S3mbSkeleton.h"

#include <nlohmann/json.hpp>

#include "core/io/formats/DracoCheck.h"
#include "core/io/formats/JsonPart.h"
#include "core/io/formats/PntsDraco.h"

namespace vestige {
namespace {

enum Compression : std::uint32_t { kPlain = 0, kDraco = 1 };
constexpr std::uint8_t kPointList = 1;
constexpr std::int32_t kNone = -1;
constexpr ScalarType kAttributeTypes[]{ScalarType::uint32, ScalarType::float32, ScalarType::float64,
                                       ScalarType::uint16};

PntsArray arrayOf(const char* name, ScalarType type, std::size_t components,
                  std::span<const std::byte> bytes) {
    return {name, type, components, bytes.data(), {}, PointField::none};
}

/// Floats of a given dimension; the dimension stands there only where the count is not zero (as the SDK reads
/// and writes it).
struct Vectors {
    std::size_t count = 0;
    std::size_t dimension = 0;
    std::span<const std::byte> bytes;
};

Vectors takeVectors(S3mbStream& stream) {
    Vectors vectors;
    vectors.count = stream.take<std::uint32_t>();
    if (vectors.count == 0) return vectors;
    vectors.dimension = stream.take<std::uint16_t>();
    stream.skip(2);
    vectors.bytes = stream.takeBytes(vectors.count, vectors.dimension * sizeof(float));
    return vectors;
}

/// `names` is JSON: the meaning of an attribute and its place among the attributes.
void nameProperties(const std::string& names, std::vector<PntsArray> attributes, PntsTables& tables,
                    const ReadJob& job) {
    if (names.empty()) return;
    const nlohmann::json tree = parseJsonObject(names, 0, {1000, 8}, job);
    for (const auto& [name, place] : tree.items()) {
        const PointField field = fieldOfName(name);
        const std::size_t at = place.is_number_unsigned() ? place.get<std::size_t>() : attributes.size();
        const bool scalar = field == PointField::intensity || field == PointField::classification ||
                            field == PointField::gpsTime || field == PointField::returnNumber ||
                            field == PointField::returnCount || field == PointField::pointSource;
        if (!scalar || tables.has(field) || at >= attributes.size() || attributes[at].components != 1) {
            tables.notKept.push_back(name);
            continue;
        }
        PntsArray property = attributes[at];
        property.name = name;
        property.field = field;
        tables.properties.push_back(std::move(property));
    }
}

void refuseInstances(S3mbStream& stream) {
    if (stream.take<std::uint16_t>() != 0) stream.refuse("the S3MB tile holds instances", "plain points");
    stream.skip(2);
}

void takeAttributes(S3mbStream& stream, PntsTables& tables, const ReadJob& job) {
    std::vector<PntsArray> attributes;
    const std::size_t count = stream.takeCount(8);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t values = stream.take<std::uint32_t>();
        const std::size_t dimension = stream.take<std::uint16_t>();
        const std::size_t type = stream.take<std::uint16_t>();
        if (type >= std::size(kAttributeTypes) || dimension == 0 || dimension > 64)
            stream.refuse("an attribute has the type " + std::to_string(type), "0 to 3, of 1 to 64 numbers");
        const auto bytes = stream.takeBytes(values, dimension * sizeOf(kAttributeTypes[type]));
        // An attribute of another length is no one per point: a dimension that nothing here takes.
        attributes.push_back(
            arrayOf("", kAttributeTypes[type], values == tables.points ? dimension : 0, bytes));
    }
    nameProperties(stream.takeString(), std::move(attributes), tables, job);
}

/// Vertices, normals, colours and attributes, one after the other.
PntsTables plainPoints(S3mbStream vertices, const ReadJob& job) {
    PntsTables tables;
    const Vectors positions = takeVectors(vertices);
    tables.points = positions.count;
    if (positions.count > 0 && (positions.dimension < 3 || positions.dimension > 4))
        vertices.refuse("the points have " + std::to_string(positions.dimension) + " coordinates", "3");
    tables.features.push_back(arrayOf("POSITION", ScalarType::float32,
                                      std::max<std::size_t>(3, positions.dimension), positions.bytes));
    const Vectors normals = takeVectors(vertices);
    if (normals.count == positions.count && normals.dimension == 3)
        tables.features.push_back(arrayOf("NORMAL", ScalarType::float32, 3, normals.bytes));
    else if (normals.count > 0)
        tables.notKept.emplace_back("normals");
    const std::size_t colors = vertices.take<std::uint32_t>();
    if (colors > 0) {
        vertices.skip(4);
        const auto bytes = vertices.takeBytes(colors, 4);
        if (colors == positions.count)
            tables.features.push_back(arrayOf("RGBA", ScalarType::uint8, 4, bytes));
        else
            tables.notKept.emplace_back("colours");
    }
    const std::size_t textures = vertices.take<std::uint16_t>();
    vertices.skip(2);
    for (std::size_t i = 0; i < textures; ++i) {
        const std::size_t values = vertices.take<std::uint32_t>();
        const std::size_t dimension = vertices.take<std::uint16_t>();
        vertices.skip(2);
        vertices.takeBytes(values, dimension * sizeof(float));
    }
    refuseInstances(vertices);
    takeAttributes(vertices, tables, job);
    return tables;
}

/// Whether every package of indices draws points; the vertices are the points, so that indices add nothing.
bool drawsPoints(S3mbStream& skeleton) {
    bool points = true;
    const std::size_t packages = skeleton.takeCount(4);
    for (std::size_t i = 0; i < packages; ++i) {
        S3mbStream package = skeleton.takeStream("an index package");
        package.skip(6);
        points &= package.take<std::uint8_t>() == kPointList;
    }
    return points;
}

std::optional<PntsTables> dracoPoints(S3mbStream packed, std::span<const std::byte> tile, double version,
                                      ReadJob& job) {
    PntsTables tables;
    packed.skip(4);
    const auto position = packed.take<std::int32_t>();
    const auto normal = packed.take<std::int32_t>();
    const auto color = packed.take<std::int32_t>();
    if (version < 3.005) packed.skip(4);  // a second colour in 3.0
    packed.takeBytes(packed.take<std::uint32_t>(), 4);
    std::vector<PntsArray> attributes;
    const std::size_t count = packed.takeCount(4);
    for (std::size_t i = 0; i < count; ++i) {
        PntsArray& attribute = attributes.emplace_back(arrayOf("", ScalarType::float32, 1, {}));
        attribute.dracoId = packed.take<std::uint32_t>();
    }
    if (packed.take<std::uint32_t>() != 0) return std::nullopt;  // with indices it is a mesh
    packed.align();
    const auto stream = packed.takeBytes(packed.take<std::uint32_t>(), 1);
    packed.align();
    nameProperties(packed.takeString(), std::move(attributes), tables, job);

    const auto offset = static_cast<std::size_t>(stream.data() - tile.data());
    tables.points = checkDracoStream(stream, offset, job).points;
    tables.draco = PntsSection{offset, stream.size()};
    const auto want = [&](std::int32_t id, const char* name, ScalarType type, std::size_t components) {
        if (id == kNone) return;
        tables.features.push_back(arrayOf(name, type, components, {}));
        tables.features.back().dracoId = static_cast<std::uint32_t>(id);
    };
    want(position, "POSITION", ScalarType::float32, 3);
    want(normal, "NORMAL", ScalarType::float32, 3);
    want(color, "RGBA", ScalarType::uint8, 4);
    if (!tables.feature("POSITION")) packed.refuse("the points have no positions", "an attribute for them");
    decodeDraco(tile, tables, job);
    return tables;
}

}  // namespace

std::optional<PntsTables> parseS3mbSkeleton(S3mbStream& skeleton, std::span<const std::byte> tile,
                                            double version, ReadJob& job) {
    const auto compression = skeleton.take<std::uint32_t>();
    if (compression == kDraco)
        return dracoPoints(skeleton.takeStream("a compressed skeleton"), tile, version, job);
    if (compression != kPlain)
        skeleton.refuse("a skeleton is compressed in the way " + std::to_string(compression),
                        "0 (none) or 1 (Draco)");
    PntsTables tables = plainPoints(skeleton.takeStream("a vertex package"), job);
    if (!drawsPoints(skeleton)) return std::nullopt;
    return tables;
}

}  // namespace vestige
