#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// An object to measure and what the tape says of it.
struct TapeRow {
    std::size_t line = 0;
    std::string object;
    std::optional<double> tape_m;
    std::optional<double> resolution_m;
    std::optional<MeasurementKind> kind;
};

/// Objects with their tape values: a table with a header that names the columns "object" and, where there are
/// any, "tape_m", "tape_resolution_m" and "kind"; others, as those of measurements.csv, are passed over. An
/// object may stand in several rows (one per method). Without a header: object, tape value in metres. Errors:
/// ErrorCode::input for no such column, a value that is no length, rows that contradict each other, with
/// `place` and line.
Result<std::vector<TapeRow>> parseTapeList(std::string_view text, const std::string& place);
Result<std::vector<TapeRow>> readTapeList(const std::filesystem::path& file);

/// The measurements that the rows change or add; what the case knows and the rows do not say stays.
std::vector<Measurement> importTapes(const SceneState& scene, const std::vector<TapeRow>& rows);

}  // namespace vestige
