#include <nlohmann/json.hpp>

#include "core/base/AtomicFile.h"
#include "core/simulation/SurveyFiles.h"

namespace vestige {
namespace {

using Json = nlohmann::ordered_json;

Json triple(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

Json layersJson(const Survey& survey, bool withHandheld) {
    Json layers = Json::array();
    layers.push_back({{"id", "aerial"},
                      {"name", "Aerial, Zenmuse L1"},
                      {"role", "aerial"},
                      {"path", "aerial.laz"},
                      {"unit", "m"}});
    if (withHandheld)
        for (const HandheldLayer& layer : survey.handheld)
            layers.push_back({{"id", layer.id},
                              {"name", layer.id + ", EinScan"},
                              {"role", "handheld"},
                              {"path", layer.id + ".ply"},
                              {"unit", "mm"},
                              {"init", {{"picks", layer.id + "_picks.csv"}}}});
    if (survey.photo)
        layers.push_back({{"id", "photo"},
                          {"name", "Photogrammetry"},
                          {"role", "photogrammetry"},
                          {"path", "photo.ply"},
                          {"unit", "m"}});
    return layers;
}

Json viewsJson(const Aiming& aiming) {
    Json views = Json::object();
    for (const auto& [name, view] : aiming.views) {
        const ViewCamera& camera = view.camera;
        Json& json = views[name];
        json = {{"position", triple(camera.position)},
                {"focal_point", triple(camera.focalPoint)},
                {"view_up", triple(camera.viewUp)},
                {"parallel", camera.parallel},
                {"vertical_angle_rad", camera.verticalAngle_rad},
                {"half_height_m", camera.halfHeight_m},
                {"width_px", camera.width_px},
                {"height_px", camera.height_px}};
        if (!view.frame.empty()) json["frame"] = view.frame;
    }
    return views;
}

Json aimJson(const SimulatedAim& aim) {
    Json json{
        {"view", aim.view}, {"pixel", {aim.pixel.x(), aim.pixel.y()}}, {"layers", Json::array({aim.layer})}};
    if (!aim.snap.empty()) json["snap"] = aim.snap;
    return json;
}

Json measurementsJson(const Aiming& aiming) {
    Json measurements = Json::array();
    for (const AimedMeasurement& measured : aiming.measurements) {
        Json aims = Json::object();
        for (const auto& [method, repeats] : measured.aims) {
            aims[method] = Json::array();
            for (const auto& [a, b] : repeats) aims[method].push_back(Json::array({aimJson(a), aimJson(b)}));
        }
        measurements.push_back({{"object", measured.object}, {"tape_m", measured.tape_m}, {"aims", aims}});
    }
    return measurements;
}

}  // namespace

Status writeSimulatedCase(const Survey& survey, const SceneSpec& spec, const Aiming& aiming,
                          bool withHandheld, const std::filesystem::path& file) {
    const SiteSpec& site = spec.site;
    const Json json{
        {"vestige", 1},
        {"name", spec.name + (withHandheld || survey.handheld.empty() ? "" : " without handheld scans")},
        {"operator", "simulated survey"},
        {"site", {{"lat", site.latitude_deg}, {"lon", site.longitude_deg}, {"height_m", site.height_m}}},
        {"layers", layersJson(survey, withHandheld)},
        {"preprocess", {{"filter", "gaussian"}, {"voxel_m", 0.2}}},
        {"registration", {{"method", "improved-ndt"}, {"target", "aerial"}}},
        {"views", viewsJson(aiming)},
        {"measurements", measurementsJson(aiming)}};
    return writeTextFile(file, json.dump(1) + "\n");
}

}  // namespace vestige
