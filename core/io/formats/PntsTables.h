#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/PointField.h"
#include "core/io/ReadJob.h"
#include "core/io/ScalarType.h"
#include "core/io/formats/PntsHeader.h"
#include "core/io/formats/TileAttributes.h"

namespace vestige {

/// One value or vector per point (or per batch), packed, little endian.
struct PntsArray {
    std::string name;
    ScalarType type = ScalarType::float32;
    std::size_t components = 1;
    const std::byte* data = nullptr;       ///< null while it waits for Draco
    std::optional<std::uint32_t> dracoId;  ///< its attribute in the Draco stream
    PointField field = PointField::none;   ///< of a property: what it means to Vestige

    std::size_t stride() const { return components * sizeOf(type); }
    double value(std::size_t i, std::size_t component = 0) const {
        return readScalar(type, data + i * stride() + component * sizeOf(type));
    }
};

/// What the feature and batch table of a point tile say. The arrays point into the tile's bytes, or into
/// `decoded`; every one of them lies within them.
struct PntsTables {
    std::size_t points = 0;
    std::size_t batches = 0;  ///< length of the properties where there is a BATCH_ID
    Eigen::Vector3d rtcCenter = Eigen::Vector3d::Zero();
    Eigen::Vector3d volumeOffset = Eigen::Vector3d::Zero();
    Eigen::Vector3d volumeScale = Eigen::Vector3d::Ones();
    std::optional<std::array<std::uint8_t, 3>> constantColor;
    std::vector<PntsArray> features;    ///< POSITION, RGB, ... under the names of the specification
    std::vector<PntsArray> properties;  ///< those whose name means something here
    std::vector<std::string> notKept;
    std::optional<PntsSection> draco;  ///< of the file's bytes
    std::string damage;                ///< of a salvaged tile: what is missing
    std::vector<std::vector<std::byte>> decoded;

    const PntsArray* feature(std::string_view name) const;
    bool has(PointField field) const;
    TileAttributes attributes() const;
};

/// Parses the tables without decoding Draco. Refuses arrays that leave their section; with `salvage`, those
/// that the end of the file cuts off are left out, and the points end with their whole positions.
PntsTables parsePntsTables(std::span<const std::byte> bytes, const PntsHeader& header, bool salvage,
                           ReadJob& job);

}  // namespace vestige
