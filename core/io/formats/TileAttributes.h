#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/io/PointField.h"

namespace vestige {

/// Which attributes the points of a tile have.
struct TileAttributes {
    bool color = false;
    bool normals = false;
    std::array<bool, static_cast<std::size_t>(PointField::returnCount) + 1> fields{};

    bool& operator[](PointField field) { return fields[static_cast<std::size_t>(field)]; }
    bool operator[](PointField field) const { return fields[static_cast<std::size_t>(field)]; }
    bool operator==(const TileAttributes&) const = default;

    void add(const TileAttributes& other);
    /// In the order and under the names of FileInfo::attributes.
    std::vector<std::string> names() const;
};

}  // namespace vestige
