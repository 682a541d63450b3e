#include "ui/view/ColorMaps.h"

#include <algorithm>
#include <cmath>

#include "ui/view/ColorScale.h"

namespace vestige {
namespace {

using Anchors = std::array<Rgb, 10>;

constexpr Anchors kViridis{{{0x44, 0x01, 0x54},
                            {0x48, 0x28, 0x78},
                            {0x3e, 0x49, 0x89},
                            {0x31, 0x68, 0x8e},
                            {0x26, 0x82, 0x8e},
                            {0x1f, 0x9e, 0x89},
                            {0x35, 0xb7, 0x79},
                            {0x6e, 0xce, 0x58},
                            {0xb5, 0xde, 0x2b},
                            {0xfd, 0xe7, 0x25}}};
constexpr Anchors kCividis{{{0x00, 0x22, 0x4e},
                            {0x12, 0x35, 0x70},
                            {0x3b, 0x49, 0x6c},
                            {0x57, 0x5d, 0x6d},
                            {0x70, 0x71, 0x73},
                            {0x8a, 0x86, 0x78},
                            {0xa5, 0x9c, 0x74},
                            {0xc3, 0xb3, 0x69},
                            {0xe1, 0xcc, 0x55},
                            {0xfe, 0xe8, 0x38}}};
constexpr Anchors kPlasma{{{0x0d, 0x08, 0x87},
                           {0x47, 0x03, 0x9f},
                           {0x73, 0x01, 0xa8},
                           {0x9c, 0x17, 0x9e},
                           {0xbd, 0x37, 0x86},
                           {0xd8, 0x57, 0x6b},
                           {0xed, 0x79, 0x53},
                           {0xfa, 0x9e, 0x3b},
                           {0xfd, 0xc9, 0x26},
                           {0xf0, 0xf9, 0x21}}};

Rgb between(const Anchors& anchors, double share) {
    const double place = share * static_cast<double>(anchors.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double part = place - static_cast<double>(before);
    Rgb color;
    for (int c = 0; c < 3; ++c)
        color[c] = static_cast<std::uint8_t>(std::lround(std::lerp(
            static_cast<double>(anchors[before][c]), static_cast<double>(anchors[before + 1][c]), part)));
    return color;
}

/// A brighter tint would be lost on white.
constexpr double kBrightestOnLight = 132;

}  // namespace

Rgb mapColor(ColorMap map, double share, Theme theme) {
    const double t = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0);
    switch (map) {
        case ColorMap::viridis:
            return between(kViridis, t);
        case ColorMap::cividis:
            return between(kCividis, t);
        case ColorMap::plasma:
            return between(kPlasma, t);
        case ColorMap::grey: {
            const bool light = theme == Theme::light;
            const auto grey = static_cast<std::uint8_t>(std::lround(light ? 20 + 190 * t : 48 + 200 * t));
            return {grey, grey, grey};
        }
        case ColorMap::even:
            break;
    }
    return heightColor(t, theme);
}

Rgb onTheme(const Rgb& color, Theme theme) {
    const double brightness = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    if (theme == Theme::dark || brightness <= kBrightestOnLight) return color;
    Rgb darker = color;
    for (std::uint8_t& part : darker)
        part = static_cast<std::uint8_t>(std::lround(part * kBrightestOnLight / brightness));
    return darker;
}

}  // namespace vestige
