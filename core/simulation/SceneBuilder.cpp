#include "core/simulation/SceneBuilder.h"

#include <stdexcept>

namespace vestige {
namespace {

void setAll(ParameterSet& set, const SceneBuilder::Values& values) {
    for (const auto& [key, value] : values)
        if (const Status done = set.set(key, value); !done) throw std::logic_error(done.error().sentence());
}

}  // namespace

ObjectSpec& SceneBuilder::add(const std::string& id, const std::string& kind, const Eigen::Vector3d& at,
                              double heading_deg, const Values& values) {
    const ShapeKind* shape = shapeKind(kind);
    if (!shape) throw std::logic_error("no shape " + kind);
    ParameterSet parameters(shape->parameters());
    setAll(parameters, values);
    spec_.objects.push_back({id, shape, std::move(parameters), at, heading_deg, 0});
    return spec_.objects.back();
}

void SceneBuilder::strip(const std::string& id, const Eigen::Vector3d& at, double length, double width,
                         const std::string& material, double roughness) {
    add(id, "ground", at, 0,
        {{"length_m", length}, {"width_m", width}, {"material", material}, {"roughness_m", roughness}});
}

void SceneBuilder::dashes(const std::string& id, double from, double to, double y) {
    // Paint lies 2 mm above the asphalt; lines of 2 m with gaps of 4 m.
    int number = 1;
    for (double x = from; x + 2 <= to; x += 6)
        strip(id + " " + std::to_string(number++), {x + 1, y, 0.002}, 2, 0.12, "road-paint");
}

void SceneBuilder::flight(const Values& values) {
    setAll(spec_.flight, values);
}

void SceneBuilder::photogrammetry(const Values& values) {
    setAll(spec_.photogrammetry, values);
}

void SceneBuilder::measure(const std::string& object, double tape_m, const std::string& from,
                           const std::string& to) {
    spec_.measurements.push_back({object, tape_m, from, to});
}

}  // namespace vestige
