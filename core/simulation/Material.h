#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace vestige {

enum class Material : std::uint8_t {
    whitePaint,
    blackPaint,
    glass,
    mirrorGlass,
    rubber,
    metal,
    plastic,
    lampCover,
    asphalt,
    concrete,
    roadPaint,
    grass,
    bark,
    leaf,
    cardboard,
    equipmentCase,
    fabric
};

/// How a surface answers light. The shares of a beam that go straight on (`passes`) and that come back
/// (`returns`, diffuse) need not add up to one: the rest is mirrored away or absorbed.
struct Optics {
    std::string_view name;
    double reflectance905;        ///< diffuse, at the laser's 905 nm
    double passes;                ///< probability that a beam goes on behind the surface
    double returns;               ///< probability that it gives a diffuse echo
    std::array<double, 3> color;  ///< albedo, linear RGB, for the photographs
    double cameraFinds;           ///< probability that image matching finds the surface in good light
};

const Optics& opticsOf(Material material);
std::optional<Material> materialFromName(std::string_view name);

}  // namespace vestige
