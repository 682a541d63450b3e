#include "core/io/formats/SbetRecord.h"

#include <cmath>
#include <numbers>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

double valueAt(std::span<const std::byte> bytes, std::size_t place) {
    return load<double>(bytes.data() + 8 * place);
}

bool withinAll(std::span<const std::byte> bytes, std::size_t first, std::size_t count, double limit) {
    for (std::size_t i = first; i < first + count; ++i)
        if (!(std::abs(valueAt(bytes, i)) <= limit)) return false;
    return true;
}

}  // namespace

SbetRecord sbetRecord(std::span<const std::byte> bytes) {
    return {valueAt(bytes, 0), valueAt(bytes, 1), valueAt(bytes, 2), valueAt(bytes, 3)};
}

const char* sbetProblem(const SbetRecord& record) {
    if (!std::isfinite(record.time)) return "the GPS time is no finite number";
    if (!(std::abs(record.latitude_rad) <= std::numbers::pi / 2)) return "the latitude is beyond a pole";
    // Longitudes are written from -180 or from 0 degrees.
    if (!(std::abs(record.longitude_rad) <= 2 * std::numbers::pi))
        return "the longitude is beyond a full turn";
    if (!(std::abs(record.height_m) <= 1e5)) return "the height is beyond 100 km";
    return nullptr;
}

bool looksLikeSbet(std::span<const std::byte> bytes) {
    if (bytes.size() < SbetRecord::kBytes) return false;
    bool anything = false;
    for (; bytes.size() >= SbetRecord::kBytes; bytes = bytes.subspan(SbetRecord::kBytes)) {
        const SbetRecord record = sbetRecord(bytes);
        if (sbetProblem(record) || record.time < 0 || record.time > 1e10) return false;
        constexpr double kTwoTurns = 4 * std::numbers::pi;
        if (!withinAll(bytes, 4, 3, 1000) || !withinAll(bytes, 7, 4, kTwoTurns)) return false;
        anything = anything || record.latitude_rad != 0 || record.longitude_rad != 0;
    }
    return anything;
}

}  // namespace vestige
