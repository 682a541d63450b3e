#pragma once

#include "core/io/formats/LasPoints.h"
#include "core/io/formats/LazCheck.h"

namespace vestige {

/// The points [begin, end) of a LAZ file of which plan.chunks are known; any thread. Throws ErrorException
/// where a chunk is damaged, after handing over the points before; see readLazPoints.
void readLayeredPoints(std::span<const std::byte> file, const LasHeader& header, const LazPlan& plan,
                       bool drawn, std::uint64_t begin, std::uint64_t end, const ReadJob& job,
                       const LasBlockHandler& handle);

}  // namespace vestige
