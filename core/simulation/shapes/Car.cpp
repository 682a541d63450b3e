#include "core/simulation/shapes/Car.h"

namespace vestige {
namespace {

/// The points that measurements and rough pairs name.
void addFeatures(ModelBuilder& builder, const CarShape& shape) {
    const double end = shape.halfLength;
    const double side = shape.halfWidth;
    builder.part("front").feature("length_front", {end, 0, 0.5}, {0.25, 0, 1}, "plane");
    builder.part("rear").feature("length_rear", {-end, 0, 0.5}, {-0.25, 0, 1}, "plane");
    const auto width = [&](const char* part, const char* name, double x, double y) {
        builder.part(part).feature(name, {x, y, 0.74}, {0, 0.45 * (y > 0 ? 1 : -1), 1}, "plane");
    };
    width("left side", "width_front_left", 0.45 * end, side);
    width("right side", "width_front_right", 0.45 * end, -side);
    width("left side", "width_rear_left", -0.3 * end, side);
    width("right side", "width_rear_right", -0.3 * end, -side);
}

}  // namespace

const ParameterTable& carParameters() {
    static const ParameterTable table{
        sizeParameter("length_m", "Length", 4.88, 3.2, 6, "Overall length, bumper to bumper."),
        sizeParameter("width_m", "Width", 1.78, 1.5, 2.2, "Width of the body without mirrors."),
        sizeParameter("height_m", "Height", 1.46, 1.3, 1.9, "Height of the roof's middle above the ground."),
        sizeParameter("wheel_diameter_m", "Wheel diameter", 0.65, 0.5, 0.75, "Outer diameter of the tyres."),
        sizeParameter("mirror_width_m", "Mirror width", 0.21, 0.1, 0.35,
                      "Width of a mirror's housing, end to end."),
        sizeParameter("handle_length_m", "Handle length", 0.26, 0.1, 0.4,
                      "Length of a door handle, end to end."),
        {"paint",
         "",
         "Paint",
         "",
         ParameterType::choice,
         std::string("white-paint"),
         {},
         {},
         {"white-paint", "black-paint", "metal"},
         "Material of the body."}};
    return table;
}

SurfaceModel buildCar(const ParameterSet& parameters, Random&) {
    const CarShape shape(parameters);
    ModelBuilder builder;
    addCarBody(builder, shape);
    addCarCabin(builder, shape);
    addCarInterior(builder, shape);
    addCarWheels(builder, shape);
    addCarMirrors(builder, shape);
    addCarHandles(builder, shape);
    addFeatures(builder, shape);
    return builder.take();
}

}  // namespace vestige
