#include "core/simulation/SceneBuilder.h"

namespace vestige {

SceneSpec twoCarsScene() {
    SceneBuilder scene("two-cars");
    scene.strip("road", {0, 0, 0}, 110, 14, "asphalt");
    scene.dashes("lane mark", -50, 50, -0.1);
    for (const double y : {-6.6, 6.6}) {
        const std::string side = y > 0 ? " north" : " south";
        scene.strip("edge line" + side, {0, 0.96 * y, 0.002}, 100, 0.15, "road-paint");
        scene.add("kerb" + side, "box", {0, 1.05 * y, 0}, 0,
                  {{"length_m", 110.0}, {"width_m", 0.25}, {"height_m", 0.12}, {"material", "concrete"}});
        scene.strip("verge" + side, {0, y > 0 ? 22.0 : -22.0, 0.08}, 110, 30, "grass", 0.02);
        scene.add("lamp 1" + side, "pole", {-9, 1.16 * y, 0.1}, y > 0 ? -90 : 90,
                  {{"height_m", 11.5}, {"diameter_m", 0.2}, {"arm_m", 1.6}, {"material", "metal"}});
        scene.add("lamp 2" + side, "pole", {15, 1.16 * y, 0.1}, y > 0 ? -90 : 90,
                  {{"height_m", 11.5}, {"diameter_m", 0.2}, {"arm_m", 1.6}, {"material", "metal"}});
    }
    scene.add("utility pole", "pole", {4, 8.4, 0.1}, 0, {{"height_m", 9.0}, {"diameter_m", 0.3}});

    scene.add("white", "car", {3.0, -1.2, 0}, 10,
              {{"length_m", 4.88}, {"width_m", 1.78}, {"mirror_width_m", 0.21}, {"handle_length_m", 0.26}});
    scene.add("black", "car", {-2.4, 0.6, 0}, -15,
              {{"length_m", 4.93},
               {"width_m", 1.84},
               {"mirror_width_m", 0.22},
               {"handle_length_m", 0.28},
               {"paint", "black-paint"}});
    scene.add("box", "box", {1.3, 2.3, 0}, 28,
              {{"length_m", 0.75}, {"width_m", 0.55}, {"height_m", 0.42}, {"material", "equipment-case"}});

    scene.flight({{"target_x_m", 1.0}, {"target_y_m", -0.3}, {"radius_m", 14.0}});
    scene.measure("Length of the white vehicle", 4.88, "white.length_front", "white.length_rear");
    scene.measure("Width of the white vehicle", 1.78, "white.width_rear_left", "white.width_rear_right");
    scene.measure("Length of the black vehicle", 4.93, "black.length_front", "black.length_rear");
    scene.measure("Width of the black vehicle", 1.84, "black.width_rear_left", "black.width_rear_right");
    scene.measure("Right rear-view mirror of the white vehicle", 0.21, "white.mirror_right_outer",
                  "white.mirror_right_inner");
    scene.measure("Right door handle of the white vehicle", 0.26, "white.handle_right_front",
                  "white.handle_right_rear");
    scene.measure("Right rear-view mirror of the black vehicle", 0.22, "black.mirror_right_outer",
                  "black.mirror_right_inner");
    scene.measure("Right door handle of the black vehicle", 0.28, "black.handle_right_front",
                  "black.handle_right_rear");
    scene.measure("Wheel diameter", 0.65, "white.wheel_rear_left_a", "white.wheel_rear_left_b");
    scene.measure("Length of box", 0.75, "box.length_a", "box.length_b");
    scene.measure("Width of box", 0.55, "box.width_a", "box.width_b");
    return scene.take();
}

}  // namespace vestige
