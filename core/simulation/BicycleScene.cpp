#include "core/simulation/SceneBuilder.h"

namespace vestige {
namespace {

void addStreet(SceneBuilder& scene) {
    scene.strip("road", {0, 3.25, 0}, 110, 10, "asphalt");
    scene.dashes("lane mark", -50, 0, 3.3);
    scene.add("island", "box", {26, 3.9, 0}, 0,
              {{"length_m", 48.0}, {"width_m", 1.4}, {"height_m", 0.12}, {"material", "concrete"}});
    scene.strip("island grass", {26, 3.9, 0.125}, 47.7, 1.1, "grass");
    scene.strip("edge line", {0, -1.3, 0.002}, 100, 0.12, "road-paint");
    for (const double y : {-1.85, 8.35}) {
        const std::string side = y > 0 ? " north" : " south";
        scene.add("kerb" + side, "box", {0, y, 0}, 0,
                  {{"length_m", 110.0}, {"width_m", 0.2}, {"height_m", 0.12}, {"material", "concrete"}});
    }
    scene.strip("grass strip", {0, -3.2, 0.10}, 110, 2.5, "grass", 0.02);
    scene.strip("pavement", {0, -6.0, 0.12}, 110, 3.1, "concrete");
    scene.strip("verge south", {0, -17.5, 0.10}, 110, 20, "grass", 0.03);
    scene.strip("verge north", {0, 18.4, 0.10}, 110, 20, "grass", 0.03);
    for (const double x : {-9.5, 12.5})
        scene.add(x < 0 ? "lamp west" : "lamp east", "pole", {x, -2.7, 0.1}, 90,
                  {{"height_m", 11.7}, {"diameter_m", 0.2}, {"arm_m", 1.8}, {"material", "metal"}});
    scene.add("utility pole", "pole", {-6.2, 9.2, 0.1}, 0, {{"height_m", 9.0}, {"diameter_m", 0.3}});
    scene.add("sign post", "pole", {-4.6, -2.3, 0.1}, 0,
              {{"height_m", 2.8}, {"diameter_m", 0.08}, {"material", "metal"}});
    const auto tree = [&](const std::string& id, double x, double y, double radius) {
        scene.add(id, "tree", {x, y, 0.1}, 0,
                  {{"canopy_radius_m", radius},
                   {"canopy_height_m", 5.2},
                   {"clearance_m", 2.2},
                   {"leaf_area_density", 3.6},
                   {"leaf_m", 0.12}});
    };
    tree("tree 1", 0.8, -2.7, 4.7);
    tree("tree 2", 5.6, -2.8, 4.2);
    tree("tree 3", 3.4, 3.9, 3.9);
    tree("tree 4", 13.5, -2.9, 3.2);
}

/// Front, right side with mirror and handle, bonnet, windscreen frame, and along the left side to where the
/// aircraft sees it: the sweeps of one scan, in the car's frame.
HandheldSpec frontScan() {
    HandheldSpec layer{"front", "car", 0.001, {}};
    layer.sweeps = {
        {{2.95, -0.75, 0.80}, {2.95, 0.75, 0.80}, {2.46, -0.70, 0.52}, {2.46, 0.70, 0.52}, 0.42, 0.60, 6},
        {{2.56, -1.10, 0.80}, {2.56, -1.10, 0.80}, {2.20, -0.73, 0.55}, {2.20, -0.73, 0.55}, 0.45, 0.60, 1},
        {{2.56, 1.10, 0.80}, {2.56, 1.10, 0.80}, {2.20, 0.73, 0.55}, {2.20, 0.73, 0.55}, 0.45, 0.60, 1},
        {{2.10, -1.45, 0.85}, {-0.50, -1.45, 0.85}, {2.05, -0.92, 0.66}, {-0.55, -0.92, 0.66}, 0.42, 0.60, 9},
        {{0.25, -1.20, 1.20}, {0.25, -1.00, 1.15}, {0.71, -1.08, 1.03}, {0.71, -1.02, 1.03}, 0.40, 0.30, 2},
        {{1.25, -1.30, 1.15}, {1.25, -1.05, 1.15}, {0.78, -1.06, 1.03}, {0.78, -1.02, 1.03}, 0.40, 0.30, 2},
        {{0.72, -1.65, 1.20}, {0.72, -1.25, 1.55}, {0.73, -1.06, 1.03}, {0.73, -1.06, 1.03}, 0.36, 0.36, 2},
        {{0.20, -1.42, 0.95},
         {-0.50, -1.42, 0.95},
         {-0.02, -0.96, 0.83},
         {-0.28, -0.96, 0.83},
         0.36,
         0.22,
         2},
        {{1.75, -0.75, 1.40}, {1.75, 0.75, 1.40}, {1.55, -0.68, 0.92}, {1.55, 0.68, 0.92}, 0.36, 0.42, 5},
        {{0.60, -1.00, 1.85}, {-0.60, -1.00, 1.85}, {0.30, -0.62, 1.40}, {-0.60, -0.62, 1.40}, 0.50, 0.40, 3},
        {{2.10, 1.45, 0.90}, {-1.90, 1.45, 0.90}, {2.05, 0.92, 0.70}, {-1.95, 0.92, 0.70}, 0.46, 0.46, 10},
        {{-2.62, 1.12, 0.90}, {-2.93, 0.40, 0.90}, {-2.24, 0.72, 0.65}, {-2.45, 0.30, 0.65}, 0.46, 0.60, 3}};
    return layer;
}

}  // namespace

SceneSpec bicycleScene() {
    SceneBuilder scene("bicycle");
    addStreet(scene);
    scene.add("car", "car", {0, 0, 0}, 0,
              {{"length_m", 4.93},
               {"width_m", 1.84},
               {"mirror_width_m", 0.22},
               {"handle_length_m", 0.28},
               {"paint", "black-paint"}});
    scene.add("bicycle", "bicycle", {-3.3, 3.0, 0}, 35, {{"length_m", 1.58}, {"wheel_diameter_m", 0.56}})
        .roll_deg = 72;
    scene.add("box", "box", {-4.6, 1.5, 0}, -22,
              {{"length_m", 0.75}, {"width_m", 0.55}, {"height_m", 0.42}, {"material", "equipment-case"}});
    const auto carton = [&](const std::string& id, double x, double y, double heading) {
        scene.add(id, "box", {x, y, 0}, heading,
                  {{"length_m", 0.42}, {"width_m", 0.42}, {"height_m", 0.38}, {"material", "cardboard"}});
    };
    carton("carton 1", -4.4, -0.6, 17);
    carton("carton 2", -2.0, 4.7, -40);
    scene.add("tripod", "tripod", {-3.7, 0.5, 0}, 75, {{"length_m", 0.44}});

    scene.handheld(frontScan());
    scene.flight({{"target_x_m", -1.2}, {"target_y_m", 0.8}, {"radius_m", 11.0}});
    scene.measure("Wheel diameter", 0.65, "car.wheel_rear_left_a", "car.wheel_rear_left_b");
    scene.measure("Length of the vehicle", 4.93, "car.length_front", "car.length_rear");
    scene.measure("Width of the vehicle", 1.84, "car.width_front_left", "car.width_front_right");
    scene.measure("Right rearview mirror", 0.22, "car.mirror_right_outer", "car.mirror_right_inner");
    scene.measure("Right door handle", 0.28, "car.handle_right_front", "car.handle_right_rear");
    scene.measure("Length of box", 0.75, "box.length_a", "box.length_b");
    scene.measure("Width of box", 0.55, "box.width_a", "box.width_b");
    scene.measure("Bicycle length", 1.58, "bicycle.front_wheel_front", "bicycle.rear_wheel_rear");
    scene.measure("Bicycle wheel", 0.56, "bicycle.front_wheel_front", "bicycle.front_wheel_rear");
    scene.measure("Length of carton", 0.42, "carton 1.length_a", "carton 1.length_b");
    scene.measure("Width of carton", 0.42, "carton 1.width_a", "carton 1.width_b");
    scene.measure("Tripod length", 0.44, "tripod.head", "tripod.foot");
    return scene.take();
}

}  // namespace vestige
