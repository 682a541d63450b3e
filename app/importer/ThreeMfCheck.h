#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vestige::importer {

/// What lib3mf says of a 3MF file.
struct ThreeMfVerdict {
    bool given = true;           ///< false: it could not say; what follows is empty
    std::uint64_t vertices = 0;  ///< of all mesh objects, each counted once
    std::uint64_t triangles = 0;
    std::vector<std::string> warnings;
};

/// Has the file read by lib3mf, which knows the rules of the core, material, production, slice and beam
/// lattice specifications. Throws ErrorException with its sentence where it refuses the file.
ThreeMfVerdict checkThreeMf(std::span<const std::byte> file);

}  // namespace vestige::importer
