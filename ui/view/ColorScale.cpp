#include "ui/view/ColorScale.h"

#include <algorithm>
#include <cmath>

#include "ui/view/SampledRange.h"

namespace vestige {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;

struct Oklch {
    double lightness;
    double chroma;
    double hue_deg;
};

std::uint8_t srgbByte(double linear) {
    const double clamped = std::clamp(linear, 0.0, 1.0);
    const double encoded =
        clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

/// Ottosson's Oklab to linear sRGB.
Rgb fromOklch(const Oklch& color) {
    const double a = color.chroma * std::cos(color.hue_deg * kRadiansPerDegree);
    const double b = color.chroma * std::sin(color.hue_deg * kRadiansPerDegree);
    const double l = std::pow(color.lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(color.lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(color.lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {srgbByte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            srgbByte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            srgbByte(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

Rgb between(const Oklch& from, const Oklch& to, double share) {
    const double t = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0);
    return fromOklch({std::lerp(from.lightness, to.lightness, t), std::lerp(from.chroma, to.chroma, t),
                      std::lerp(from.hue_deg, to.hue_deg, t)});
}

/// 1, 2 or 5 times a power of ten, at least `value`.
double roundedUp(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= value * (1 - 1e-9)) return step * power;
    return 10 * power;
}

std::optional<ColorScale> heightScale(const ViewDescription& view) {
    SampledRange heights;
    for (const ViewLayer& layer : view.layers) {
        if (!isDrawn(layer) || !layer.geometry) continue;
        const PointCloud& cloud = layer.geometry->vertices;
        heights.sample(cloud.size(),
                       [&](std::size_t i) { return (layer.worldFromLayer * cloud.point(i)).z(); });
    }
    if (heights.empty()) return std::nullopt;
    ColorScale scale{"Height", "m", heights.quantile(0.01), heights.quantile(0.99)};
    if (scale.high - scale.low < 1e-6) scale.high = scale.low + 1;
    return scale;
}

std::optional<ColorScale> residualScale(const ViewDescription& view) {
    SampledRange residuals;
    for (const ViewLayer& layer : view.layers)
        if (layer.visible && layer.residual_m)
            residuals.sample(layer.residual_m->size(),
                             [&](std::size_t i) { return std::abs((*layer.residual_m)[i]); });
    if (residuals.empty()) return std::nullopt;
    ColorScale scale{"Distance to target", "mm", 0, 1, 1000, true};
    scale.high = roundedUp(std::max(1e-4, residuals.quantile(0.9)));
    return scale;
}

constexpr Rgb kTargetTint{142, 170, 200};
constexpr std::array<Rgb, 4> kSourceTints{
    {{244, 154, 52}, {232, 104, 124}, {190, 140, 240}, {120, 205, 130}}};

}  // namespace

Rgb ColorScale::at(double value) const {
    const double share = (value - low) / (high - low);
    return warm ? errorColor(share) : heightColor(share);
}

Rgb heightColor(double share) {
    return between({0.47, 0.115, 272}, {0.93, 0.125, 100}, share);
}

Rgb errorColor(double share) {
    const double t = std::clamp(std::isfinite(share) ? share : 1.0, 0.0, 1.0);
    constexpr Oklch kNone{0.56, 0.05, 245};
    constexpr Oklch kSome{0.83, 0.13, 85};
    constexpr Oklch kMuch{0.62, 0.22, 25};
    if (t > 0.5) return between(kSome, kMuch, 2 * t - 1);
    // Through neutral grey, not round the hue circle.
    const Oklch grey{std::lerp(kNone.lightness, kSome.lightness, 0.35), 0.012, 160};
    return t < 0.18 ? between(kNone, {grey.lightness, grey.chroma, 245}, t / 0.18)
                    : between({grey.lightness, grey.chroma, 85}, kSome, (t - 0.18) / 0.32);
}

std::optional<ColorScale> colorScale(const ViewDescription& view) {
    if (view.overlay == Overlay::residual) return residualScale(view);
    if (view.overlay == Overlay::none && view.colorMode == ColorMode::height) return heightScale(view);
    return std::nullopt;
}

std::size_t targetLayer(const ViewDescription& view) {
    const auto flagged = std::find_if(view.layers.begin(), view.layers.end(),
                                      [](const ViewLayer& layer) { return layer.isTarget; });
    return flagged == view.layers.end() ? 0 : static_cast<std::size_t>(flagged - view.layers.begin());
}

Rgb layerTint(const ViewDescription& view, std::size_t layer) {
    if (view.overlay != Overlay::registration) return view.layers[layer].tint;
    const std::size_t target = targetLayer(view);
    if (layer == target) return kTargetTint;
    return kSourceTints[(layer - (layer > target ? 1 : 0)) % kSourceTints.size()];
}

}  // namespace vestige
