#pragma once

#include "core/io/formats/LasPoints.h"

namespace vestige {

/// Every point of a LAZ file in order, through LASzip. What LASzip would trust without looking (its own
/// record, the chunk table) is checked against the file first and refused at its byte. Refuses data that end
/// early or are damaged.
void readLazPoints(std::span<const std::byte> file, const LasHeader& header, const ReadJob& job,
                   const LasPointHandler& handle);

}  // namespace vestige
