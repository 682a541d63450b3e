#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/io/ReadJob.h"

namespace vestige {

/// What a JSON text inside a format may cost.
struct JsonLimits {
    std::size_t values = std::size_t{4} << 20;
    int depth = 256;
};

/// The tree of `text`, which begins at byte `offset` of the job's file. Refuses what is no JSON object, at
/// its byte, and what exceeds the limits.
nlohmann::json parseJsonObject(std::string_view text, std::size_t offset, const JsonLimits& limits,
                               const ReadJob& job);

/// A whole number from 0 to 2^53 of an object; nothing when there is no such key. Refuses anything else.
std::optional<std::size_t> jsonCount(const nlohmann::json& object, const char* key, std::size_t offset,
                                     const ReadJob& job);

}  // namespace vestige
