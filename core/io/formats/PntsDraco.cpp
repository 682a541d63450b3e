#include "core/io/formats/PntsDraco.h"

#include <draco/compression/decode.h>

#include <cstring>
#include <utility>

#include "core/io/formats/DracoCheck.h"

namespace vestige {
namespace {

std::optional<ScalarType> scalarOf(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8:
            return ScalarType::int8;
        case draco::DT_UINT8:
            return ScalarType::uint8;
        case draco::DT_INT16:
            return ScalarType::int16;
        case draco::DT_UINT16:
            return ScalarType::uint16;
        case draco::DT_INT32:
            return ScalarType::int32;
        case draco::DT_UINT32:
            return ScalarType::uint32;
        case draco::DT_INT64:
            return ScalarType::int64;
        case draco::DT_UINT64:
            return ScalarType::uint64;
        case draco::DT_FLOAT32:
            return ScalarType::float32;
        case draco::DT_FLOAT64:
            return ScalarType::float64;
        default:
            return std::nullopt;
    }
}

/// The attribute's values point after point; every address is checked.
std::vector<std::byte> valuesOf(const draco::PointAttribute& attribute, std::size_t points,
                                const PntsArray& array, std::size_t offset, const ReadJob& job) {
    const std::size_t stride = array.stride();
    const draco::DataBuffer* buffer = attribute.buffer();
    std::vector<std::byte> values(points * stride);
    for (std::size_t i = 0; i < points; ++i) {
        const draco::PointIndex point(static_cast<std::uint32_t>(i));
        if (!attribute.is_mapping_identity() && i >= attribute.indices_map_size())
            job.refuseByte(offset, "the Draco stream leaves points without " + array.name, "all points");
        const auto index = attribute.mapped_index(point);
        const auto at = attribute.GetBytePos(index);
        if (!buffer || at < 0 || static_cast<std::size_t>(at) + stride > buffer->data_size())
            job.refuseByte(offset, "the Draco stream has too few values of " + array.name, "one per point");
        std::memcpy(values.data() + i * stride, buffer->data() + at, stride);
    }
    return values;
}

void fill(PntsArray& array, const draco::PointCloud& cloud, PntsTables& tables, const ReadJob& job) {
    if (!array.dracoId) return;
    const std::size_t offset = tables.draco->begin;
    const draco::PointAttribute* attribute = cloud.GetAttributeByUniqueId(*array.dracoId);
    if (!attribute)
        job.refuseByte(
            offset,
            "the Draco stream has no attribute " + std::to_string(*array.dracoId) + " for " + array.name,
            "the attributes that the tables name");
    const auto type = scalarOf(attribute->data_type());
    const bool sameKind = type && (array.field != PointField::none || *type == array.type ||
                                   (array.name == "BATCH_ID" && isInteger(*type)));
    const auto components = static_cast<std::size_t>(attribute->num_components());
    const bool color = (array.name == "RGB" || array.name == "RGBA") && components >= 3;
    if (!sameKind || (components != array.components && !color))
        job.refuseByte(offset, "the Draco stream has another type of " + array.name, "that of the tables");
    array.components = components;
    array.type = *type;
    tables.decoded.push_back(valuesOf(*attribute, tables.points, array, offset, job));
    array.data = tables.decoded.back().data();
}

}  // namespace

void decodeDraco(std::span<const std::byte> bytes, PntsTables& tables, ReadJob& job) {
    if (!tables.draco) return;
    const std::size_t offset = tables.draco->begin;
    const auto stream = bytes.subspan(offset, tables.draco->length);
    const DracoPromise promise = checkDracoStream(stream, offset, job);
    if (promise.points != tables.points)
        job.refuseByte(offset,
                       "the Draco stream holds " + counted(promise.points, "point") +
                           ", the feature table promises " + std::to_string(tables.points),
                       "equal numbers");
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(stream.data()), stream.size());
    draco::Decoder decoder;
    auto cloud = decoder.DecodePointCloudFromBuffer(&buffer);
    if (!cloud.ok() || !cloud.value())
        job.refuseByte(offset, "the Draco stream cannot be decoded: " + cloud.status().error_msg_string(),
                       "a whole stream");
    if (cloud.value()->num_points() != tables.points)
        job.refuseByte(offset, "the Draco stream decodes to " + counted(cloud.value()->num_points(), "point"),
                       std::to_string(tables.points));
    for (PntsArray& array : tables.features) fill(array, *cloud.value(), tables, job);
    for (PntsArray& array : tables.properties) fill(array, *cloud.value(), tables, job);
}

}  // namespace vestige
