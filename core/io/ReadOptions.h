#pragma once

#include <cstdint>
#include <optional>

#include "core/geometry/BoundingBox.h"

namespace vestige {

/// What of a file is wanted. Readers of large formats heed it while they read; readGeometry() applies it to
/// what the others return, so that every format behaves alike.
struct ReadOptions {
    /// `drawn`: position, intensity, colour, class where any point has one, normals and triangles, which the
    /// view, picking and registration need; the rest (time, source, returns) stays in the file until someone
    /// reads with `all`.
    enum class Attributes { all, drawn };
    Attributes attributes = Attributes::all;
    /// Only points in this box (in the file's own unit and frame); a mesh loses the triangles that leave it.
    std::optional<BoundingBox> box;
    /// Only every k-th point of those, the first included; meshes are not thinned.
    std::uint32_t keepEvery = 1;
    /// Of a file that ends early, or is damaged from some place on, what is whole is read; FileInfo::damage
    /// then says what is missing. Without it such files are refused.
    bool salvage = false;

    bool wholeFile() const { return !box && keepEvery <= 1; }
};

}  // namespace vestige
