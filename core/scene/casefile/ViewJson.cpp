#include <nlohmann/json.hpp>
#include <numbers>

#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

nlohmann::ordered_json vectorJson(const Eigen::Vector3d& vector) {
    return std::vector<double>(vector.begin(), vector.end());
}

}  // namespace

nlohmann::ordered_json viewJson(const ViewCamera& camera, const std::string& frame) {
    nlohmann::ordered_json json{{"position", vectorJson(camera.position)},
                                {"focal_point", vectorJson(camera.focalPoint)},
                                {"view_up", vectorJson(camera.viewUp)},
                                {"parallel", camera.parallel},
                                {"vertical_angle_rad", camera.verticalAngle_rad},
                                {"half_height_m", camera.halfHeight_m},
                                {"width_px", camera.width_px},
                                {"height_px", camera.height_px}};
    if (!frame.empty()) json["frame"] = frame;
    return json;
}

ViewCamera readView(const JsonCursor& cursor) {
    constexpr std::int64_t kLargestPicture_px = 65536;
    cursor.warnOfOthers({"position", "focal_point", "view_up", "parallel", "vertical_angle_rad",
                         "half_height_m", "width_px", "height_px", "frame"});
    ViewCamera camera;
    camera.position = cursor.at("position").vector3();
    camera.focalPoint = cursor.at("focal_point").vector3();
    camera.viewUp = cursor.at("view_up").vector3();
    if (camera.position == camera.focalPoint)
        cursor.reject("position and focal point coincide", "expected a direction to look in");
    if (camera.viewUp.cross(camera.focalPoint - camera.position).isZero(0))
        cursor.reject("view_up is zero or points along the direction of view");
    if (const auto parallel = cursor.find("parallel")) camera.parallel = parallel->boolean();
    if (const auto angle = cursor.find("vertical_angle_rad")) {
        camera.verticalAngle_rad = angle->realAbove0();
        if (camera.verticalAngle_rad >= std::numbers::pi)
            angle->reject("the angle of view is too wide", "expected radians below pi");
    }
    if (const auto height = cursor.find("half_height_m")) camera.halfHeight_m = height->realAbove0();
    if (const auto width = cursor.find("width_px"))
        camera.width_px = static_cast<int>(width->integer(1, kLargestPicture_px));
    if (const auto height = cursor.find("height_px"))
        camera.height_px = static_cast<int>(height->integer(1, kLargestPicture_px));
    return camera;
}

}  // namespace vestige
