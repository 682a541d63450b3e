#include "core/io/formats/JsonPart.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/JsonSize.h"

namespace vestige {

nlohmann::json parseJsonObject(std::string_view text, std::size_t offset, const JsonLimits& limits,
                               const ReadJob& job) {
    const JsonSize size = jsonSize(text);
    if (size.depth > limits.depth)
        job.refuseByte(offset, "the JSON is nested " + std::to_string(size.depth) + " deep",
                       "at most " + std::to_string(limits.depth));
    if (size.values > limits.values)
        job.refuseByte(offset, "the JSON holds " + std::to_string(size.values) + " values",
                       "at most " + std::to_string(limits.values));
    try {
        nlohmann::json tree = nlohmann::json::parse(text);
        if (!tree.is_object()) job.refuseByte(offset, "the JSON is no object", "{ ... }");
        return tree;
    } catch (const nlohmann::json::parse_error& error) {
        job.refuseByte(offset + (error.byte > 0 ? error.byte - 1 : 0), "this is not JSON", "JSON in UTF-8");
    } catch (const nlohmann::json::out_of_range&) {
        job.refuseByte(offset, "a number is too large to be held", "numbers in the range of a double");
    }
}

std::optional<std::size_t> jsonCount(const nlohmann::json& object, const char* key, std::size_t offset,
                                     const ReadJob& job) {
    const auto found = object.find(key);
    if (found == object.end()) return std::nullopt;
    const double value = found->is_number() ? found->get<double>() : -1;
    if (!(value >= 0 && value <= 9007199254740992.0) || value != std::floor(value))
        job.refuseByte(offset, std::string(key) + " is " + found->dump().substr(0, 40),
                       "a whole number from 0 on");
    return static_cast<std::size_t>(value);
}

}  // namespace vestige
