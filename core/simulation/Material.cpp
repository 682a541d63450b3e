#include "core/simulation/Material.h"

#include <cstddef>

namespace vestige {
namespace {

// Reflectances at 905 nm: rounded from published spectra of car paint, asphalt, concrete and vegetation
// (leaves and grass are bright in the near infrared, black paint and rubber are not). Plain values, listed in
// docs/simulation.md.
constexpr std::array<Optics, 17> kOptics{{
    {"white-paint", 0.75, 0, 1, {0.80, 0.80, 0.78}, 0.90},
    {"black-paint", 0.06, 0, 1, {0.03, 0.03, 0.035}, 0.70},
    {"glass", 0.10, 0.70, 0.05, {0.02, 0.02, 0.02}, 0.03},
    {"mirror-glass", 0.10, 0, 0.05, {0.05, 0.05, 0.05}, 0.03},
    {"rubber", 0.06, 0, 1, {0.025, 0.025, 0.025}, 0.80},
    {"metal", 0.45, 0, 0.8, {0.45, 0.45, 0.46}, 0.75},
    {"plastic", 0.12, 0, 1, {0.05, 0.05, 0.05}, 0.85},
    {"lamp-cover", 0.30, 0.3, 0.5, {0.55, 0.53, 0.50}, 0.30},
    {"asphalt", 0.20, 0, 1, {0.09, 0.09, 0.09}, 0.97},
    {"concrete", 0.45, 0, 1, {0.32, 0.31, 0.29}, 0.97},
    {"road-paint", 0.70, 0, 1, {0.70, 0.70, 0.68}, 0.95},
    {"grass", 0.45, 0, 1, {0.06, 0.11, 0.03}, 0.85},
    {"bark", 0.40, 0, 1, {0.12, 0.09, 0.06}, 0.95},
    {"leaf", 0.50, 0.05, 0.95, {0.05, 0.10, 0.03}, 0.60},
    {"cardboard", 0.65, 0, 1, {0.42, 0.30, 0.18}, 0.95},
    {"equipment-case", 0.15, 0, 1, {0.06, 0.06, 0.07}, 0.90},
    {"fabric", 0.25, 0, 1, {0.05, 0.05, 0.055}, 0.90},
}};

}  // namespace

const Optics& opticsOf(Material material) {
    return kOptics[static_cast<std::size_t>(material)];
}

std::optional<Material> materialFromName(std::string_view name) {
    for (std::size_t i = 0; i < kOptics.size(); ++i)
        if (kOptics[i].name == name) return static_cast<Material>(i);
    return std::nullopt;
}

}  // namespace vestige
