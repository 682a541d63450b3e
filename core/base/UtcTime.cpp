#include "core/base/UtcTime.h"

#include <ctime>

namespace vestige {

std::string utcNow() {
    return utcText(std::time(nullptr));
}

std::string utcText(std::int64_t seconds) {
    const std::time_t now = seconds;
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

}  // namespace vestige
