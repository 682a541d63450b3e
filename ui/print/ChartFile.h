#pragma once

#include <filesystem>
#include <span>

#include "core/base/Result.h"
#include "core/report/Section.h"

namespace vestige {

/// PNG or SVG, by the extension.
bool isChartFile(const std::filesystem::path& file);

/// The charts below one another with their captions, as a picture of their own. A QGuiApplication must exist.
/// Atomic; ErrorCode::usage for another extension, ErrorCode::output.
Status writeCharts(std::span<const LineChart> charts, const std::filesystem::path& file);

}  // namespace vestige
