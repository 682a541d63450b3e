#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/base/Units.h"
#include "core/simulation/shapes/Shapes.h"

namespace vestige {
namespace {

using Point = Eigen::Vector3d;

Point randomDirection(Random& random) {
    Point direction;
    do {
        direction = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    } while (direction.squaredNorm() > 1 || direction.squaredNorm() < 1e-4);
    return direction.normalized();
}

}  // namespace

const ParameterTable& treeParameters() {
    static const ParameterTable table{
        sizeParameter("clearance_m", "Clearance", 2.4, 0.5, 20, "Height of the lowest leaves."),
        sizeParameter("canopy_radius_m", "Canopy radius", 3.2, 0.3, 20, "Half width of the canopy."),
        sizeParameter("canopy_height_m", "Canopy height", 4.5, 0.3, 30, "Height of the canopy alone."),
        {"leaf_area_density",
         "",
         "Leaf area density",
         "1/m",
         ParameterType::real,
         1.6,
         0,
         10,
         {},
         "One-sided leaf area in a cubic metre of canopy."},
        sizeParameter("leaf_m", "Leaf", 0.10, 0.01, 1, "Side of a leaf facet (a spray of leaves)."),
        sizeParameter("trunk_diameter_m", "Trunk diameter", 0.3, 0.02, 3, "Diameter at the foot.")};
    return table;
}

SurfaceModel buildTree(const ParameterSet& parameters, Random& random) {
    ModelBuilder builder;
    const double clearance = parameters.real("clearance_m");
    const double radius = parameters.real("canopy_radius_m");
    const double height = parameters.real("canopy_height_m");
    const double leaf = parameters.real("leaf_m");
    const double trunk = 0.5 * parameters.real("trunk_diameter_m");
    const Point middle(0, 0, clearance + 0.5 * height);
    builder.part("trunk").material(Material::bark);
    builder.tube({0, 0, 0}, middle, trunk, 0.6 * trunk, 14);
    for (int branch = 0; branch < 9; ++branch) {
        const double angle = radians(40.0 * branch) + random.uniform(-0.3, 0.3);
        const double lift = random.uniform(0.1, 0.7);
        const Point from(0, 0, random.uniform(clearance, clearance + 0.45 * height));
        const Point tip = from + 0.75 * radius * Point(std::cos(angle), std::sin(angle), lift);
        builder.tube(from, tip, 0.3 * trunk, 0.1 * trunk, 8);
    }
    builder.part("leaves").material(Material::leaf);
    const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * 0.5 * height;
    const auto leaves = static_cast<long>(volume * parameters.real("leaf_area_density") / (leaf * leaf));
    for (long i = 0; i < leaves; ++i) {
        Point inside;
        do {
            inside = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        } while (inside.squaredNorm() > 1);
        const Point at = middle + inside.cwiseProduct(Point(radius, radius, 0.5 * height));
        const Point along = randomDirection(random);
        const Point across = along.cross(randomDirection(random)).normalized();
        const double half = 0.5 * leaf;
        builder.quad(at - half * along - half * across, at + half * along - half * across,
                     at + half * along + half * across, at - half * along + half * across);
    }
    return builder.take();
}

}  // namespace vestige
