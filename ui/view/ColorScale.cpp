#include "ui/view/ColorScale.h"

#include <algorithm>
#include <cmath>

#include "ui/view/ClassColors.h"
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

/// From the values' own shares, or from what was typed.
void setRange(ColorScale& scale, SampledRange& values, const ColorRange& range) {
    const double cut = std::clamp(range.cut, 0.0, 0.4);
    scale.low = range.low.value_or(values.quantile(cut));
    scale.high = range.high.value_or(values.quantile(1 - cut));
    if (scale.high - scale.low < 1e-6) scale.high = scale.low + 1;
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
    ColorScale scale{"Height", "m", 0, 0, 1, {}, view.theme, false, view.coloring.map};
    setRange(scale, heights, view.coloring.height_m);
    return scale;
}

std::optional<ColorScale> intensityScale(const ViewDescription& view) {
    SampledRange strengths;
    int scans = 0;
    for (const ViewLayer& layer : view.layers) {
        if (!isDrawn(layer) || !layer.geometry) continue;
        const auto& intensity = layer.geometry->vertices.attributes().intensity;
        scans += !intensity.empty();
        strengths.sample(intensity.size(), [&](std::size_t i) { return intensity[i]; });
    }
    // Scanners count on scales of their own: one for several only where it was typed.
    const ColorRange& range = view.coloring.intensity;
    if (strengths.empty() || (scans > 1 && !range.low && !range.high)) return std::nullopt;
    ColorScale scale{"Intensity", "as recorded", 0, 0, 1, {}, view.theme, false, ColorMap::grey};
    scale.power = 0.5;
    setRange(scale, strengths, range);
    return scale;
}

std::optional<ColorScale> classScale(const ViewDescription& view) {
    ColorScale scale{"Class", "", 0, 1, 1, {}, view.theme};
    scale.classes = classesShown(view);
    if (scale.classes.empty()) return std::nullopt;
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
    const double reach = std::max(1e-6, view.coloring.reach_m.value_or(roundedUp(std::max(1e-4, 3 * noise))));
    const bool metres = reach >= 1;
    return ColorScale{"Distance to the target's surface",
                      metres ? "m" : "mm",
                      -reach,
                      reach,
                      metres ? 1.0 : 1000.0,
                      noise,
                      view.theme,
                      view.coloring.reach_m.has_value()};
}

constexpr Rgb kTargetTints[] = {{142, 170, 200}, {86, 108, 134}};
constexpr std::array<Rgb, 4> kSourceTints[] = {
    {{{244, 154, 52}, {232, 104, 124}, {190, 140, 240}, {120, 205, 130}}},
    {{{214, 106, 0}, {190, 40, 92}, {124, 66, 190}, {20, 122, 70}}}};
std::size_t place(Theme theme) {
    return theme == Theme::light ? 1 : 0;
}

}  // namespace

Rgb ColorScale::at(double value) const {
    if (noise) return differenceColor(value / high, theme);
    const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return mapColor(map, power == 1 ? share : std::pow(share, power), theme);
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
    if (view.overlay != Overlay::none) return std::nullopt;
    switch (view.colorMode) {
        case ColorMode::height:
            return heightScale(view);
        case ColorMode::intensity:
            return intensityScale(view);
        case ColorMode::classification:
            return classScale(view);
        case ColorMode::rgb:
        case ColorMode::source:
            break;
    }
    return std::nullopt;
}

std::size_t targetLayer(const ViewDescription& view) {
    const auto flagged = std::find_if(view.layers.begin(), view.layers.end(),
                                      [](const ViewLayer& layer) { return layer.isTarget; });
    return static_cast<std::size_t>(flagged - view.layers.begin());
}

Rgb layerTint(const ViewDescription& view, std::size_t layer) {
    const std::size_t theme = place(view.theme);
    if (view.overlay != Overlay::registration) return onTheme(view.layers[layer].tint, view.theme);
    const std::size_t target = targetLayer(view);
    if (layer == target) return kTargetTints[theme];
    return kSourceTints[theme][(layer - (layer > target ? 1 : 0)) % kSourceTints[theme].size()];
}

}  // namespace vestige
