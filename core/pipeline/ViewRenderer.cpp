#include "core/pipeline/ViewRenderer.h"

namespace vestige {

std::string_view name(ColorMode mode) {
    switch (mode) {
        case ColorMode::height:
            return "height";
        case ColorMode::intensity:
            return "intensity";
        case ColorMode::rgb:
            return "rgb";
        case ColorMode::source:
            return "source";
        case ColorMode::classification:
            return "class";
    }
    return "";
}

std::optional<ColorMode> colorModeFromName(std::string_view text) {
    for (const auto mode : {ColorMode::height, ColorMode::intensity, ColorMode::rgb, ColorMode::source,
                            ColorMode::classification})
        if (name(mode) == text) return mode;
    return std::nullopt;
}

std::string_view name(Overlay overlay) {
    switch (overlay) {
        case Overlay::none:
            return "none";
        case Overlay::registration:
            return "registration";
        case Overlay::residual:
            return "residual";
        case Overlay::source:
            return "source";
    }
    return "";
}

std::optional<Overlay> overlayFromName(std::string_view text) {
    for (const auto overlay : {Overlay::none, Overlay::registration, Overlay::residual, Overlay::source})
        if (name(overlay) == text) return overlay;
    return std::nullopt;
}

std::string_view name(Theme theme) {
    return theme == Theme::light ? "light" : "dark";
}

std::optional<Theme> themeFromName(std::string_view text) {
    for (const auto theme : {Theme::dark, Theme::light})
        if (name(theme) == text) return theme;
    return std::nullopt;
}

BoundingBox bounds(const ViewDescription& view) {
    BoundingBox box;
    for (const ViewLayer& layer : view.layers)
        if (isDrawn(layer) && layer.geometry)
            box.add(layer.geometry->vertices.bounds().transformed(layer.worldFromLayer));
    return box;
}

}  // namespace vestige
