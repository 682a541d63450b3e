#include "ui/view/PointColors.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"
#include "ui/view/SampledRange.h"

namespace vestige {
namespace {

using Rgba = std::array<std::uint8_t, 4>;
constexpr std::size_t kGrain = 65536;

template <class ColorOf>
std::vector<Rgba> fill(std::size_t count, const ColorOf& colorOf) {
    std::vector<Rgba> colors(count);
    parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Rgb color = colorOf(i);
            colors[i] = {color[0], color[1], color[2], 255};
        }
    });
    return colors;
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
    Brightness(const PointAttributes& attributes, bool fromIntensity) : attributes_(attributes) {
        intensity_ = fromIntensity && !attributes.intensity.empty();
        if (!intensity_ && attributes.color.empty()) return;
        SampledRange range;
        range.sample(intensity_ ? attributes.intensity.size() : attributes.color.size(),
                     [&](std::size_t i) { return raw(i); });
        if (range.empty()) return;
        low_ = range.quantile(0.02);
        span_ = range.quantile(0.98) - low_;
    }

    bool known() const { return span_ > 0; }
    double at(std::size_t i) const { return std::clamp((raw(i) - low_) / span_, 0.0, 1.0); }

  private:
    double raw(std::size_t i) const {
        return intensity_ ? attributes_.intensity[i] : luminance(attributes_.color[i]);
    }

    const PointAttributes& attributes_;
    bool intensity_ = false;
    double low_ = 0;
    double span_ = 0;
};

std::vector<Rgba> tinted(const PointCloud& cloud, const Rgb& tint) {
    const Brightness brightness(cloud.attributes(), true);
    if (!brightness.known()) return fill(cloud.size(), [&](std::size_t) { return tint; });
    return fill(cloud.size(), [&](std::size_t i) { return scaled(tint, 0.55 + 0.55 * brightness.at(i)); });
}

std::vector<Rgba> byIntensity(const PointCloud& cloud, const Rgb& tint) {
    const Brightness brightness(cloud.attributes(), true);
    if (cloud.attributes().intensity.empty() || !brightness.known()) return tinted(cloud, tint);
    return fill(cloud.size(), [&](std::size_t i) {
        const auto grey = static_cast<std::uint8_t>(std::lround(48 + 200 * std::sqrt(brightness.at(i))));
        return Rgb{grey, grey, grey};
    });
}

std::vector<Rgba> byColor(const PointCloud& cloud, const Rgb& tint) {
    const auto& color = cloud.attributes().color;
    if (color.empty()) return tinted(cloud, tint);
    return fill(cloud.size(), [&](std::size_t i) {
        return Rgb{static_cast<std::uint8_t>(color[i][0] >> 8), static_cast<std::uint8_t>(color[i][1] >> 8),
                   static_cast<std::uint8_t>(color[i][2] >> 8)};
    });
}

std::vector<Rgba> byHeight(const ViewLayer& layer, const ColorScale& scale) {
    const PointCloud& cloud = layer.geometry->vertices;
    const auto steps = table([&](double share) { return heightColor(share, scale.theme); });
    return fill(cloud.size(), [&](std::size_t i) {
        const double height = (layer.worldFromLayer * cloud.point(i)).z();
        return lookUp(steps, (height - scale.low) / (scale.high - scale.low), neutralColor(scale.theme));
    });
}

std::vector<Rgba> byResidual(const ViewLayer& layer, const ColorScale& scale) {
    const auto steps = table([&](double share) { return differenceColor(2 * share - 1, scale.theme); });
    const Rgb uncompared = uncomparedColor(scale.theme);
    return fill(layer.residual_m->size(), [&](std::size_t i) {
        return lookUp(steps, 0.5 + 0.5 * (*layer.residual_m)[i] / scale.high, uncompared);
    });
}

}  // namespace

std::vector<Rgba> pointColors(const ViewDescription& view, std::size_t index,
                              const std::optional<ColorScale>& scale) {
    const ViewLayer& layer = view.layers[index];
    const PointCloud& cloud = layer.geometry->vertices;
    if (view.overlay == Overlay::residual) {
        const bool measured = layer.residual_m && layer.residual_m->size() == cloud.size();
        return measured && scale ? byResidual(layer, *scale) : tinted(cloud, neutralColor(view.theme));
    }
    const Rgb tint = layerTint(view, index);
    if (view.overlay != Overlay::none) return tinted(cloud, tint);
    switch (view.colorMode) {
        case ColorMode::height:
            if (scale) return byHeight(layer, *scale);
            break;
        case ColorMode::intensity:
            return byIntensity(cloud, tint);
        case ColorMode::rgb:
            return byColor(cloud, tint);
        case ColorMode::source:
            break;
    }
    return tinted(cloud, tint);
}

}  // namespace vestige
