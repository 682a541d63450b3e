#include "core/simulation/SceneModel.h"

#include <Eigen/Geometry>
#include <limits>

#include "core/base/Units.h"

namespace vestige {
namespace {

/// Every object has its own stream of random numbers, so that one more object changes no other.
constexpr std::uint64_t kObjectStreams = 1000;

Pose placeObject(const ObjectSpec& object, const SurfaceModel& surfaces) {
    Pose pose = Pose::Identity();
    pose.translation() = object.at;
    pose.rotate(Eigen::AngleAxisd(radians(object.heading_deg), Eigen::Vector3d::UnitZ()));
    if (object.roll_deg == 0) return pose;
    pose.rotate(Eigen::AngleAxisd(radians(object.roll_deg), Eigen::Vector3d::UnitX()));
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& vertex : surfaces.vertices) lowest = std::min(lowest, (pose * vertex).z());
    pose.pretranslate(Eigen::Vector3d(0, 0, object.at.z() - lowest));
    return pose;
}

}  // namespace

Result<SceneModel> buildScene(const SceneSpec& spec, std::uint64_t seed) {
    SceneModel scene;
    std::uint64_t stream = kObjectStreams;
    for (const ObjectSpec& object : spec.objects) {
        Random random(seed, stream++);
        const SurfaceModel surfaces = object.kind->build(object.parameters, random);
        const Pose pose = placeObject(object, surfaces);
        scene.siteFromObject.emplace(object.id, pose);
        scene.surfaces.append(surfaces, pose, object.id);
    }
    if (scene.surfaces.faces.empty())
        return fail(ErrorCode::input, "the scene has no objects", spec.name, "at least one was expected");
    if (scene.surfaces.parts.size() > 60000)
        return fail(ErrorCode::input, "the scene has too many objects", spec.name, "up to 60000 parts");
    for (const HandheldSpec& layer : spec.handheld)
        if (!spec.object(layer.object))
            return fail(ErrorCode::input, "handheld layer " + layer.id + " is of an unknown object",
                        spec.name, layer.object);
    for (const MeasurementSpec& measurement : spec.measurements)
        for (const std::string& name : {measurement.from, measurement.to})
            if (!scene.surfaces.feature(name))
                return fail(ErrorCode::input,
                            "measurement \"" + measurement.object + "\" names an unknown feature", spec.name,
                            name);
    return scene;
}

}  // namespace vestige
