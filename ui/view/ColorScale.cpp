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

/// A number with at most two digits, at least `value`.
double roundedUp(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
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
    ColorScale scale{"Height", "m", heights.quantile(0.01), heights.quantile(0.99), 1, {}, view.theme};
    if (scale.high - scale.low < 1e-6) scale.high = scale.low + 1;
    return scale;
}

std::optional<ColorScale> residualScale(const ViewDescription& view) {
    SampledRange distances;
    for (const ViewLayer& layer : view.layers)
        if (layer.visible && layer.residual_m)
            distances.sample(layer.residual_m->size(), [&](std::size_t i) { return (*layer.residual_m)[i]; });
    if (distances.empty()) return std::nullopt;
    const double median = distances.quantile(0.5);
    SampledRange deviations;
    for (const ViewLayer& layer : view.layers)
        if (layer.visible && layer.residual_m)
            deviations.sample(layer.residual_m->size(),
                              [&](std::size_t i) { return std::abs((*layer.residual_m)[i] - median); });
    const double noise = 1.4826 * deviations.quantile(0.5);
    const double reach = roundedUp(std::max(1e-4, 3 * noise));
    const bool metres = reach >= 1;
    return ColorScale{"Distance to the target's surface",
                      metres ? "m" : "mm",
                      -reach,
                      reach,
                      metres ? 1.0 : 1000.0,
                      noise,
                      view.theme};
}

constexpr Rgb kTargetTints[] = {{142, 170, 200}, {86, 108, 134}};
constexpr std::array<Rgb, 4> kSourceTints[] = {
    {{{244, 154, 52}, {232, 104, 124}, {190, 140, 240}, {120, 205, 130}}},
    {{{214, 106, 0}, {190, 40, 92}, {124, 66, 190}, {20, 122, 70}}}};
/// A brighter tint would be lost on white.
constexpr double kBrightestOnLight = 132;

std::size_t place(Theme theme) {
    return theme == Theme::light ? 1 : 0;
}

Rgb ownTint(const Rgb& tint, Theme theme) {
    const double brightness = 0.2126 * tint[0] + 0.7152 * tint[1] + 0.0722 * tint[2];
    if (theme == Theme::dark || brightness <= kBrightestOnLight) return tint;
    Rgb darker = tint;
    for (std::uint8_t& part : darker)
        part = static_cast<std::uint8_t>(std::lround(part * kBrightestOnLight / brightness));
    return darker;
}

}  // namespace

Rgb ColorScale::at(double value) const {
    if (noise) return differenceColor(value / high, theme);
    return heightColor((value - low) / (high - low), theme);
}

Rgb heightColor(double share, Theme theme) {
    if (theme == Theme::light) return between({0.34, 0.13, 285}, {0.74, 0.155, 100}, share);
    return between({0.47, 0.115, 272}, {0.93, 0.125, 100}, share);
}

Rgb differenceColor(double share, Theme theme) {
    const double t = std::clamp(std::isfinite(share) ? share : 0.0, -1.0, 1.0);
    const bool light = theme == Theme::light;
    const double hue = t < 0 ? 258 : 50;
    const Oklch none{light ? 0.74 : 0.80, 0.008, hue};
    const Oklch most = t < 0 ? Oklch{light ? 0.40 : 0.50, 0.19, hue} : Oklch{light ? 0.56 : 0.64, 0.19, hue};
    return between(none, most, std::abs(t));
}

Rgb uncomparedColor(Theme theme) {
    return theme == Theme::light ? Rgb{196, 178, 206} : Rgb{92, 76, 104};
}

Rgb neutralColor(Theme theme) {
    return theme == Theme::light ? Rgb{198, 204, 211} : Rgb{66, 74, 84};
}

Rgb selectionColor(Theme theme) {
    return theme == Theme::light ? Rgb{196, 0, 136} : Rgb{255, 72, 196};
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
    const std::size_t theme = place(view.theme);
    if (view.overlay != Overlay::registration) return ownTint(view.layers[layer].tint, view.theme);
    const std::size_t target = targetLayer(view);
    if (layer == target) return kTargetTints[theme];
    return kSourceTints[theme][(layer - (layer > target ? 1 : 0)) % kSourceTints[theme].size()];
}

}  // namespace vestige
