#pragma once

#include <cstdint>
#include <string>

namespace vestige {

/// Now in UTC, as ISO 8601 to the second: 2026-01-31T12:00:00Z.
std::string utcNow();
/// The same of a time in seconds since 1970, UTC.
std::string utcText(std::int64_t seconds);

}  // namespace vestige
