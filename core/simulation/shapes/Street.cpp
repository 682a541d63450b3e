#include <algorithm>
#include <cmath>
#include <vector>

#include "core/simulation/shapes/Shapes.h"

namespace vestige {

using Point = Eigen::Vector3d;

const ParameterTable& groundParameters() {
    static const ParameterTable table{
        sizeParameter("length_m", "Length", 100, 0.01, 1000, "Size along x."),
        sizeParameter("width_m", "Width", 8, 0.01, 1000, "Size along y."),
        sizeParameter("roughness_m", "Roughness", 0, 0, 1, "Height of random bumps, one sigma."),
        sizeParameter("cell_m", "Cell", 0.5, 0.05, 100, "Spacing of the bumps."),
        materialParameter("asphalt")};
    return table;
}

SurfaceModel buildGround(const ParameterSet& parameters, Random& random) {
    ModelBuilder builder;
    const double length = parameters.real("length_m");
    const double width = parameters.real("width_m");
    const double roughness = parameters.real("roughness_m");
    const double cell = parameters.real("cell_m");
    builder.part("ground").material(*materialFromName(parameters.text("material")));
    const int rows = roughness > 0 ? std::max(1, static_cast<int>(std::lround(length / cell))) : 1;
    const int columns = roughness > 0 ? std::max(1, static_cast<int>(std::lround(width / cell))) : 1;
    std::vector<double> bumps(static_cast<std::size_t>(rows + 1) * static_cast<std::size_t>(columns + 1));
    for (double& bump : bumps) bump = roughness > 0 ? random.normal(0, roughness) : 0;
    builder.grid(rows, columns, [&](int row, int column) -> Point {
        const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns + 1) +
                           static_cast<std::size_t>(column);
        return {length * (static_cast<double>(row) / rows - 0.5),
                width * (static_cast<double>(column) / columns - 0.5), bumps[index]};
    });
    return builder.take();
}

const ParameterTable& poleParameters() {
    static const ParameterTable table{
        sizeParameter("height_m", "Height", 9, 0.5, 40, "Height of the pole."),
        sizeParameter("diameter_m", "Diameter", 0.22, 0.02, 2, "Diameter at the foot."),
        sizeParameter("arm_m", "Arm", 0, 0, 10,
                      "Length of a lamp's arm along x; 0 for a pole without a lamp."),
        materialParameter("concrete")};
    return table;
}

SurfaceModel buildPole(const ParameterSet& parameters, Random&) {
    ModelBuilder builder;
    const double height = parameters.real("height_m");
    const double radius = 0.5 * parameters.real("diameter_m");
    const double arm = parameters.real("arm_m");
    builder.part("pole").material(*materialFromName(parameters.text("material")));
    builder.tube({0, 0, 0}, {0, 0, height}, radius, 0.6 * radius, 16);
    builder.feature("top", {0, 0, height}, {0, 0, 1});
    if (arm > 0) {
        const Point lamp(arm, 0, height + 0.3);
        builder.tube({0, 0, height - 0.1}, lamp, 0.05, 0.04, 10);
        builder.part("lamp").material(Material::plastic);
        builder.box(lamp + Point(0.25, 0, 0), {0.7, 0.3, 0.12});
        builder.light(lamp + Point(0.25, 0, -0.1));
    }
    return builder.take();
}

}  // namespace vestige
