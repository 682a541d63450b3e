#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/io/formats/PntsTables.h"
#include "core/io/formats/S3mbStream.h"

namespace vestige {

/// The points of a skeleton behind its name, plain or in Draco; nothing for lines and surfaces. `tile` is
/// what the stream walks over. Refuses instances and unknown ways of compression.
std::optional<PntsTables> parseS3mbSkeleton(S3mbStream& skeleton, std::span<const std::byte> tile,
                                            double version, ReadJob& job);

}  // namespace vestige
