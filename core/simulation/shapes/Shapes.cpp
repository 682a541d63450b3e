#include "core/simulation/shapes/Shapes.h"

#include <algorithm>

#include "core/simulation/shapes/Car.h"

namespace vestige {

const std::vector<ShapeKind>& shapeKinds() {
    static const std::vector<ShapeKind> kinds{
        {"car", carParameters, buildCar},         {"bicycle", bicycleParameters, buildBicycle},
        {"box", boxParameters, buildBox},         {"tripod", tripodParameters, buildTripod},
        {"tree", treeParameters, buildTree},      {"pole", poleParameters, buildPole},
        {"ground", groundParameters, buildGround}};
    return kinds;
}

const ShapeKind* shapeKind(std::string_view name) {
    const auto& kinds = shapeKinds();
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const ShapeKind& kind) { return kind.name == name; });
    return found == kinds.end() ? nullptr : &*found;
}

ParameterSpec sizeParameter(const char* key, const char* label, double value, double least, double most,
                            const char* help) {
    return {key, "", label, "m", ParameterType::real, value, least, most, {}, help};
}

ParameterSpec materialParameter(const char* value) {
    return {"material",
            "",
            "Material",
            "",
            ParameterType::choice,
            std::string(value),
            {},
            {},
            {"asphalt", "concrete", "road-paint", "grass", "cardboard", "equipment-case", "metal", "plastic",
             "white-paint", "black-paint"},
            "What the surface is made of."};
}

}  // namespace vestige
