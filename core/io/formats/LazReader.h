#pragma once

#include "core/io/formats/LasPoints.h"
#include "core/io/formats/LazCheck.h"

namespace vestige {

/// The points [begin, end) of a LAZ file, through LayeredChunk or LASzip; any thread. Throws ErrorException
/// where the data end early or are damaged, after handing over all points before. With `drawn` the layers (of
/// point formats 6 and later) that hold neither position, intensity, colour nor flags are not unpacked.
void readLazPoints(std::span<const std::byte> file, const LasHeader& header, const LazPlan& plan, bool drawn,
                   std::uint64_t begin, std::uint64_t end, const ReadJob& job, const LasBlockHandler& handle);

}  // namespace vestige
