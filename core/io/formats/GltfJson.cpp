#include "core/io/formats/GltfJson.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace vestige {

using nlohmann::json;

json parseGltfJson(std::string_view text, std::size_t byteOfText, const ReadJob& job) {
    constexpr int kDeepest = 64;
    const auto callback = [&](int depth, json::parse_event_t, json&) {
        if (depth > kDeepest)
            job.refuse("the JSON is nested too deep", "at most " + std::to_string(kDeepest) + " levels");
        return true;
    };
    try {
        return json::parse(text, callback);
    } catch (const json::parse_error& problem) {
        job.refuseByte(byteOfText + (problem.byte > 0 ? problem.byte - 1 : 0), "this is no JSON",
                       "a glTF document in JSON");
    } catch (const json::out_of_range&) {
        job.refuse("a number of the JSON is too large", "numbers that a double can hold");
    }
}

void GltfJson::refuse(const char* key, const std::string& expected) const {
    job_.refuse("'" + std::string(key) + "' of the glTF document is missing or of a wrong type", expected);
}

const json* GltfJson::member(const json& object, const char* key) const {
    if (!object.is_object()) refuse(key, "an object that holds it");
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

std::size_t GltfJson::count(const char* list) const {
    const json* items = member(document_, list);
    if (!items) return 0;
    if (!items->is_array()) refuse(list, "a list");
    return items->size();
}

const json& GltfJson::item(const char* list, std::uint64_t index, const std::string& why) const {
    if (index >= count(list))
        job_.refuse(why + " names item " + std::to_string(index) + " of '" + list + "'",
                    std::to_string(count(list)) + " items, counted from 0");
    const json& found = document_[list][index];
    if (!found.is_object()) refuse(list, "a list of objects");
    return found;
}

std::optional<std::uint64_t> GltfJson::find(const json& object, const char* key) const {
    const json* value = member(object, key);
    if (!value) return std::nullopt;
    if (value->is_number_unsigned()) return value->get<std::uint64_t>();
    // Some writers put every number down as a real one.
    if (value->is_number_float()) {
        const double real = value->get<double>();
        if (real >= 0 && real < 9e15 && real == std::floor(real)) return static_cast<std::uint64_t>(real);
    }
    refuse(key, "a whole number from 0");
}

std::uint64_t GltfJson::number(const json& object, const char* key) const {
    const auto value = find(object, key);
    if (!value) refuse(key, "a whole number from 0");
    return *value;
}

std::uint64_t GltfJson::number(const json& object, const char* key, std::uint64_t otherwise) const {
    return find(object, key).value_or(otherwise);
}

std::string GltfJson::text(const json& object, const char* key) const {
    const json* value = member(object, key);
    if (!value) return {};
    if (!value->is_string()) refuse(key, "a text");
    return value->get<std::string>();
}

bool GltfJson::flag(const json& object, const char* key) const {
    const json* value = member(object, key);
    if (value && !value->is_boolean()) refuse(key, "true or false");
    return value && value->get<bool>();
}

std::vector<std::uint64_t> GltfJson::numbers(const json& object, const char* key) const {
    const json* value = member(object, key);
    if (!value) return {};
    if (!value->is_array()) refuse(key, "a list of whole numbers");
    std::vector<std::uint64_t> result;
    for (const json& entry : *value) {
        if (!entry.is_number_unsigned()) refuse(key, "a list of whole numbers from 0");
        result.push_back(entry.get<std::uint64_t>());
    }
    return result;
}

std::optional<std::vector<double>> GltfJson::reals(const json& object, const char* key,
                                                   std::size_t length) const {
    const json* value = member(object, key);
    if (!value) return std::nullopt;
    const std::string expected = std::to_string(length) + " finite numbers";
    if (!value->is_array() || value->size() != length) refuse(key, expected);
    std::vector<double> result;
    for (const json& entry : *value) {
        if (!entry.is_number() || !std::isfinite(entry.get<double>())) refuse(key, expected);
        result.push_back(entry.get<double>());
    }
    return result;
}

std::vector<std::string> GltfJson::texts(const json& object, const char* key) const {
    const json* value = member(object, key);
    if (!value) return {};
    if (!value->is_array()) refuse(key, "a list of texts");
    std::vector<std::string> result;
    for (const json& entry : *value) {
        if (!entry.is_string()) refuse(key, "a list of texts");
        result.push_back(entry.get<std::string>());
    }
    return result;
}

}  // namespace vestige
