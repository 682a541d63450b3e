#include <cmath>

#include "core/base/Units.h"
#include "core/simulation/shapes/Shapes.h"

namespace vestige {

using Point = Eigen::Vector3d;

const ParameterTable& boxParameters() {
    static const ParameterTable table{sizeParameter("length_m", "Length", 0.75, 0.01, 1000, "Size along x."),
                                      sizeParameter("width_m", "Width", 0.55, 0.01, 1000, "Size along y."),
                                      sizeParameter("height_m", "Height", 0.45, 0.001, 200, "Size upwards."),
                                      materialParameter("equipment-case")};
    return table;
}

SurfaceModel buildBox(const ParameterSet& parameters, Random&) {
    ModelBuilder builder;
    const double length = parameters.real("length_m");
    const double width = parameters.real("width_m");
    const double height = parameters.real("height_m");
    builder.part("box").material(*materialFromName(parameters.text("material")));
    builder.box({0, 0, 0.5 * height}, {length, width, height});
    builder.feature("length_a", {0.5 * length, 0, height}, {0.2, 0, 1}, "edge");
    builder.feature("length_b", {-0.5 * length, 0, height}, {-0.2, 0, 1}, "edge");
    builder.feature("width_a", {0, 0.5 * width, height}, {0, 0.2, 1}, "edge");
    builder.feature("width_b", {0, -0.5 * width, height}, {0, -0.2, 1}, "edge");
    return builder.take();
}

const ParameterTable& tripodParameters() {
    static const ParameterTable table{sizeParameter("length_m", "Length", 0.44, 0.1, 2,
                                                    "Length of a leg, from the head's top to the foot."),
                                      {"spread_deg",
                                       "",
                                       "Spread",
                                       "deg",
                                       ParameterType::real,
                                       28.0,
                                       5,
                                       60,
                                       {},
                                       "Angle of a leg from upright."}};
    return table;
}

SurfaceModel buildTripod(const ParameterSet& parameters, Random&) {
    ModelBuilder builder;
    const double length = parameters.real("length_m");
    const double spread = radians(parameters.real("spread_deg"));
    const double height = length * std::cos(spread);
    const double reach = length * std::sin(spread);
    const Point top(0, 0, height);
    for (int leg = 0; leg < 3; ++leg) {
        const double angle = radians(120.0 * leg);
        const Point foot(reach * std::cos(angle), reach * std::sin(angle), 0);
        builder.part("leg " + std::to_string(leg + 1)).material(Material::metal);
        builder.tube(top, foot, 0.015, 0.012, 12);
        if (leg == 0) builder.feature("foot", foot, {std::cos(spread), 0, std::sin(spread) + 0.4}, "surface");
    }
    builder.part("head").material(Material::plastic);
    builder.tube(top - Point(0, 0, 0.05), top, 0.035, 16);
    builder.feature("head", top, {0.3, 0, 1}, "surface");
    return builder.take();
}

}  // namespace vestige
