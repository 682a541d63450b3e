#pragma once

#include <filesystem>

#include "core/base/Result.h"

class QImage;

namespace vestige {

/// Writes a picture, whole or not at all; the same bytes for the same pixels. ErrorCode::output on failure.
Status writePng(const QImage& picture, const std::filesystem::path& png);

}  // namespace vestige
