#include "ui/view/PointColors.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/Parallel.h"
#include "ui/view/ClassColors.h"
#include "ui/view/SampledRange.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
using Geometry = std::shared_ptr<const TriangleMesh>;

template <class ColorOf>
PointPainter painter(ColorOf colorOf) {
    return [colorOf = std::move(colorOf)](std::size_t i) {
        const Rgb color = colorOf(i);
        return Rgba{color[0], color[1], color[2], 255};
    };
}

/// 256 steps of a scale: enough for the eye, and no power functions for millions of points.
template <class Color>
std::array<Rgb, 256> table(const Color& color) {
    std::array<Rgb, 256> steps;
    for (int i = 0; i < 256; ++i) steps[i] = color(i / 255.0);
    return steps;
}

Rgb lookUp(const std::array<Rgb, 256>& steps, double share, const Rgb& otherwise) {
    if (!std::isfinite(share)) return otherwise;
    return steps[static_cast<std::size_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)))];
}

Rgb scaled(const Rgb& color, double factor) {
    Rgb result;
    for (int c = 0; c < 3; ++c)
        result[c] = static_cast<std::uint8_t>(std::clamp(std::lround(color[c] * factor), 0L, 255L));
    return result;
}

double luminance(const Color& color) {
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

/// Brightness of points, 0 to 1 between the 2 % and 98 % values, from intensity or else colour.
class Brightness {
  public:
    explicit Brightness(Geometry geometry) : geometry_(std::move(geometry)) {
        intensity_ = !attributes().intensity.empty();
        sample();
        // Photogrammetric clouds have the field in their files, and nothing in it.
        if (known() || !intensity_) return;
        intensity_ = false;
        sample();
    }

    bool known() const { return span_ > 0; }
    double at(std::size_t i) const { return std::clamp((raw(i) - low_) / span_, 0.0, 1.0); }

  private:
    const PointAttributes& attributes() const { return geometry_->vertices.attributes(); }
    void sample() {
        const std::size_t count = intensity_ ? attributes().intensity.size() : attributes().color.size();
        if (count == 0) return;
        SampledRange range;
        range.sample(count, [&](std::size_t i) { return raw(i); });
        if (range.empty()) return;
        low_ = range.quantile(0.02);
        span_ = range.quantile(0.98) - low_;
    }
    double raw(std::size_t i) const {
        return intensity_ ? attributes().intensity[i] : luminance(attributes().color[i]);
    }

    Geometry geometry_;
    bool intensity_ = false;
    double low_ = 0;
    double span_ = 0;
};

PointPainter tinted(const Geometry& geometry, const Rgb& tint) {
    const Brightness brightness(geometry);
    if (!brightness.known()) return painter([tint](std::size_t) { return tint; });
    return painter(
        [brightness, tint](std::size_t i) { return scaled(tint, 0.55 + 0.55 * brightness.at(i)); });
}

/// By the layer's own range of intensities.
PointPainter byOwnIntensity(const Geometry& geometry, const Rgb& tint, Theme theme) {
    const Brightness brightness(geometry);
    if (!brightness.known()) return tinted(geometry, tint);
    const auto steps = table([&](double share) { return mapColor(ColorMap::grey, std::sqrt(share), theme); });
    return painter(
        [brightness, steps, tint](std::size_t i) { return lookUp(steps, brightness.at(i), tint); });
}

PointPainter byIntensity(const Geometry& geometry, const Rgb& tint, const std::optional<ColorScale>& scale,
                         Theme theme) {
    if (geometry->vertices.attributes().intensity.empty()) return tinted(geometry, tint);
    if (!scale) return byOwnIntensity(geometry, tint, theme);
    const auto steps =
        table([&](double share) { return mapColor(ColorMap::grey, std::pow(share, scale->power), theme); });
    return painter([geometry, steps, tint, low = scale->low, span = scale->high - scale->low](std::size_t i) {
        return lookUp(steps, (geometry->vertices.attributes().intensity[i] - low) / span, tint);
    });
}

PointPainter byClass(const Geometry& geometry, const Rgb& tint, Theme theme) {
    if (geometry->vertices.attributes().classification.empty()) return tinted(geometry, tint);
    std::array<Rgb, 256> colors;
    for (std::size_t code = 0; code < colors.size(); ++code)
        colors[code] = classColor(static_cast<std::uint8_t>(code), theme);
    return painter([geometry, colors](std::size_t i) {
        return colors[geometry->vertices.attributes().classification[i]];
    });
}

PointPainter byColor(const Geometry& geometry, const Rgb& tint) {
    if (geometry->vertices.attributes().color.empty()) return tinted(geometry, tint);
    return painter([geometry](std::size_t i) {
        const Color& color = geometry->vertices.attributes().color[i];
        return Rgb{static_cast<std::uint8_t>(color[0] >> 8), static_cast<std::uint8_t>(color[1] >> 8),
                   static_cast<std::uint8_t>(color[2] >> 8)};
    });
}

PointPainter byHeight(const ViewLayer& layer, const ColorScale& scale) {
    const auto steps = table([&](double share) { return mapColor(scale.map, share, scale.theme); });
    const Rgb neutral = neutralColor(scale.theme);
    return painter([geometry = layer.geometry, place = layer.worldFromLayer, steps, neutral, low = scale.low,
                    span = scale.high - scale.low](std::size_t i) {
        return lookUp(steps, ((place * geometry->vertices.point(i)).z() - low) / span, neutral);
    });
}

PointPainter byResidual(const ViewLayer& layer, const ColorScale& scale) {
    const auto steps = table([&](double share) { return differenceColor(2 * share - 1, scale.theme); });
    const Rgb uncompared = uncomparedColor(scale.theme);
    return painter([residuals = layer.residual_m, steps, uncompared, most = scale.high](std::size_t i) {
        return lookUp(steps, 0.5 + 0.5 * (*residuals)[i] / most, uncompared);
    });
}

PointPainter plainPainter(const ViewDescription& view, std::size_t index,
                          const std::optional<ColorScale>& scale) {
    const ViewLayer& layer = view.layers[index];
    const std::size_t points = layer.geometry->vertices.size();
    if (view.overlay == Overlay::residual) {
        const bool measured = layer.residual_m && layer.residual_m->size() == points;
        return measured && scale ? byResidual(layer, *scale)
                                 : tinted(layer.geometry, neutralColor(view.theme));
    }
    const Rgb tint = layerTint(view, index);
    if (view.overlay != Overlay::none) return tinted(layer.geometry, tint);
    switch (view.colorMode) {
        case ColorMode::height:
            if (scale) return byHeight(layer, *scale);
            break;
        case ColorMode::intensity:
            return byIntensity(layer.geometry, tint, scale, view.theme);
        case ColorMode::classification:
            return byClass(layer.geometry, tint, view.theme);
        case ColorMode::rgb:
            return byColor(layer.geometry, tint);
        case ColorMode::source:
            break;
    }
    return tinted(layer.geometry, tint);
}

}  // namespace

PointPainter pointPainter(const ViewDescription& view, std::size_t index,
                          const std::optional<ColorScale>& scale) {
    const ViewLayer& layer = view.layers[index];
    PointPainter plain = plainPainter(view, index, scale);
    const std::size_t points = layer.geometry->vertices.size();
    const auto usable = [&](const auto& flags) { return flags && flags->size() == points ? flags : nullptr; };
    const auto selected = usable(layer.selected);
    const auto hidden = usable(layer.hidden);
    if (!selected && !hidden) return plain;
    return [plain = std::move(plain), selected, hidden, color = selectionColor(view.theme)](std::size_t i) {
        if (hidden && (*hidden)[i]) return Rgba{0, 0, 0, 0};
        if (selected && (*selected)[i]) return Rgba{color[0], color[1], color[2], 255};
        return plain(i);
    };
}

std::vector<Rgba> pointColors(const ViewDescription& view, std::size_t index,
                              const std::optional<ColorScale>& scale) {
    const PointPainter paint = pointPainter(view, index, scale);
    std::vector<Rgba> colors(view.layers[index].geometry->vertices.size());
    parallelFor(colors.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) colors[i] = paint(i);
    });
    return colors;
}

}  // namespace vestige
