#include "core/io/formats/GltfAccessors.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace vestige {
namespace {

using nlohmann::json;

std::uint64_t componentBytes(std::uint64_t type) {
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

std::uint64_t components(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type.size() == 4 && type.starts_with("VEC") && type[3] >= '2' && type[3] <= '4')
        return static_cast<std::uint64_t>(type[3] - '0');
    return 0;
}

}  // namespace

GltfAccessors::GltfAccessors(const GltfJson& source) : source_(source) {}
GltfAccessors::~GltfAccessors() = default;

GltfAccessor GltfAccessors::take(std::uint64_t index, const std::string& why) {
    if (const auto known = taken_.find(index); known != taken_.end()) return known->second;
    const json& from = source_.item("accessors", index, why);
    GltfAccessor accessor;
    accessor.type = source_.text(from, "type");
    accessor.componentType = source_.number(from, "componentType");
    accessor.normalized = source_.flag(from, "normalized");
    accessor.count = source_.number(from, "count");
    const std::uint64_t item = componentBytes(accessor.componentType) * components(accessor.type);
    if (item == 0)
        source_.job().refuse("accessor " + std::to_string(index) + " of " + why + " holds '" + accessor.type +
                                 "' of the component type " + std::to_string(accessor.componentType),
                             "scalars or vectors of the types that glTF 2.0 lists");
    if (accessor.count == 0 || accessor.count > 0xffffffff)
        source_.job().refuse("accessor " + std::to_string(index) + " of " + why + " promises " +
                                 std::to_string(accessor.count) + " items",
                             "at least one, and as many as its buffer view holds");
    accessor.bytes = item * accessor.count;
    // All zeros by the specification; Assimp has no data for them.
    if (!from.contains("bufferView"))
        source_.job().refuse("accessor " + std::to_string(index) + " of " + why + " names no buffer view",
                             "accessors with a buffer view");
    json to = {{"type", accessor.type}, {"componentType", accessor.componentType}, {"count", accessor.count}};
    if (accessor.normalized) to["normalized"] = true;
    if (const auto view = source_.find(from, "bufferView")) {
        const std::uint64_t offset = source_.number(from, "byteOffset", 0);
        to["bufferView"] = takeView(*view, offset, item, accessor.count, why);
        to["byteOffset"] = offset;
    }
    if (from.contains("sparse")) takeSparse(from["sparse"], to, accessor, why);
    accessor.number = newAccessors_.size();
    newAccessors_.push_back(std::move(to));
    taken_.emplace(index, accessor);
    return accessor;
}

void GltfAccessors::takeSparse(const json& from, json& to, const GltfAccessor& accessor,
                               const std::string& why) {
    const std::uint64_t count = source_.number(from, "count");
    if (!from.contains("indices") || !from.contains("values") || count > accessor.count)
        source_.job().refuse("a sparse accessor of " + why + " is not whole",
                             "'indices' and 'values', no more than the accessor has items");
    const json& indices = from["indices"];
    const json& values = from["values"];
    const std::uint64_t type = source_.number(indices, "componentType");
    if (type != 5121 && type != 5123 && type != 5125)
        source_.job().refuse(
            "the indices of a sparse accessor of " + why + " are of the type " + std::to_string(type),
            "5121, 5123 or 5125");
    const std::uint64_t atIndices = source_.number(indices, "byteOffset", 0);
    const std::uint64_t atValues = source_.number(values, "byteOffset", 0);
    const std::uint64_t indexView =
        takeView(source_.number(indices, "bufferView"), atIndices, componentBytes(type), count, why);
    const std::uint64_t valueView =
        takeView(source_.number(values, "bufferView"), atValues, accessor.bytes / accessor.count, count, why);
    to["sparse"] = {
        {"count", count},
        {"indices", {{"bufferView", indexView}, {"byteOffset", atIndices}, {"componentType", type}}},
        {"values", {{"bufferView", valueView}, {"byteOffset", atValues}}}};
}

std::uint64_t GltfAccessors::takeView(std::uint64_t index, std::uint64_t offset, std::uint64_t itemBytes,
                                      std::uint64_t count, const std::string& why) {
    const json& from = source_.item("bufferViews", index, why);
    const std::uint64_t buffer = source_.number(from, "buffer");
    const std::uint64_t begin = source_.number(from, "byteOffset", 0);
    const std::uint64_t length = source_.number(from, "byteLength");
    const std::uint64_t stride = source_.number(from, "byteStride", itemBytes);
    const std::uint64_t whole =
        source_.number(source_.item("buffers", buffer, "buffer view " + std::to_string(index)), "byteLength");
    if (begin > whole || length > whole - begin)
        source_.job().refuse("buffer view " + std::to_string(index) + " leaves its buffer",
                             "a view inside the buffer's " + std::to_string(whole) + " bytes");
    if (stride < itemBytes || stride > 252 + itemBytes)
        source_.job().refuse(
            "buffer view " + std::to_string(index) + " has a stride of " + std::to_string(stride) + " bytes",
            "at least an item's " + std::to_string(itemBytes) + ", at most 252");
    // Counts are below 2^32 and strides small, so this cannot overflow.
    if (count > 0 && (offset > length || stride * (count - 1) + itemBytes > length - offset))
        source_.job().refuse(
            "an accessor of " + why + " leaves buffer view " + std::to_string(index),
            std::to_string(count) + " items inside the view's " + std::to_string(length) + " bytes");
    if (const auto known = views_.find(index); known != views_.end()) return known->second;
    const auto number = bufferNumbers_.emplace(buffer, buffers_.size());
    if (number.second) buffers_.push_back(buffer);
    json to = {{"buffer", number.first->second}, {"byteOffset", begin}, {"byteLength", length}};
    if (from.contains("byteStride")) to["byteStride"] = stride;
    newViews_.push_back(std::move(to));
    return views_.emplace(index, newViews_.size() - 1).first->second;
}

void GltfAccessors::putInto(json& document) && {
    document["accessors"] = std::move(newAccessors_);
    document["bufferViews"] = std::move(newViews_);
    document["buffers"] = json::array();
    for (std::size_t i = 0; i < buffers_.size(); ++i) {
        const json& from = source_.item("buffers", buffers_[i], "a buffer view");
        document["buffers"].push_back(
            {{"uri", std::to_string(i)}, {"byteLength", source_.number(from, "byteLength")}});
    }
}

}  // namespace vestige
