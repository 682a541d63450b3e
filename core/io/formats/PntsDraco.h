#pragma once

#include <cstddef>
#include <span>

#include "core/io/formats/PntsTables.h"

namespace vestige {

/// Decodes the Draco stream of a point tile and fills the arrays that wait for it. The stream's own promises
/// (points, attributes, bytes a point) are read and checked against its length before the decoder sees it, so
/// that it cannot be made to fill the memory. Refuses streams that do not fit the tables.
void decodeDraco(std::span<const std::byte> bytes, PntsTables& tables, ReadJob& job);

}  // namespace vestige
