#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/io/formats/ZipDirectory.h"

namespace vestige::importer {

/// An archived file inflated: exactly ZipEntry::size bytes, whose CRC is checked. Throws ErrorException.
std::vector<std::byte> inflated(std::span<const std::byte> archive, const ZipEntry& entry);

}  // namespace vestige::importer
