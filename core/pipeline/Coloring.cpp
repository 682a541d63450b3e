#include "core/pipeline/Coloring.h"

namespace vestige {

std::string_view name(ColorMap map) {
    switch (map) {
        case ColorMap::even:
            return "even";
        case ColorMap::viridis:
            return "viridis";
        case ColorMap::cividis:
            return "cividis";
        case ColorMap::plasma:
            return "plasma";
        case ColorMap::grey:
            return "grey";
    }
    return "";
}

std::optional<ColorMap> colorMapFromName(std::string_view text) {
    for (const auto map :
         {ColorMap::even, ColorMap::viridis, ColorMap::cividis, ColorMap::plasma, ColorMap::grey})
        if (name(map) == text) return map;
    return std::nullopt;
}

}  // namespace vestige
