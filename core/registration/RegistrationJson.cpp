#include "core/registration/RegistrationJson.h"

#include <nlohmann/json.hpp>

namespace vestige {

namespace {

nlohmann::json candidatesJson(const std::vector<PoseCandidate>& candidates) {
    nlohmann::json list = nlohmann::json::array();
    for (const PoseCandidate& one : candidates)
        list.push_back({{"pose", rowMajor(one.targetFromSource.pose)},
                        {"scale", one.targetFromSource.scale},
                        {"score", one.score}});
    return list;
}

}  // namespace

nlohmann::ordered_json qualityJson(const RegistrationQuality& quality) {
    nlohmann::ordered_json directions = nlohmann::ordered_json::array();
    for (const ObservedDirection& one : quality.directions)
        directions.push_back({{"information", one.information},
                              {"direction", std::vector<double>(one.direction.begin(), one.direction.end())},
                              {"sigma_m", one.sigma_m},
                              {"free", one.free},
                              {"words", one.words}});
    const Eigen::Vector3d& pivot = quality.uncertainty.pivot_m;
    return {{"residual_histogram",
             {{"width_m", quality.residuals.width_m},
              {"counts", quality.residuals.counts},
              {"outside", quality.residuals.outside}}},
            {"plane_rmse_m", quality.planeRmse_m},
            {"restarts",
             {{"runs", quality.restarts.runs},
              {"agreeing", quality.restarts.agreeing},
              {"translation_m", quality.restarts.translation_m},
              {"rotation_rad", quality.restarts.rotation_rad}}},
            {"observability", std::move(directions)},
            {"radius_m", quality.radius_m},
            {"covariance", rowMajor(quality.uncertainty.covariance)},
            {"pivot_m", {pivot.x(), pivot.y(), pivot.z()}}};
}

nlohmann::json registrationJson(const RegistrationResult& result, bool withSeconds) {
    nlohmann::json levels = nlohmann::json::array();
    for (const RegistrationLevel& level : result.levels)
        levels.push_back({{"voxel_m", level.voxel_m},
                          {"iterations", level.iterations},
                          {"score", level.score},
                          {"stop", std::string(describe(level.stop))}});
    nlohmann::json object{
        {"method", result.method},
        {"converged", result.converged},
        {"iterations", result.iterations},
        {"pose", rowMajor(result.targetFromSource.pose)},
        {"scale", result.targetFromSource.scale},
        {"rmse_m", result.rmse_m},
        {"overlap", result.overlap},
        {"target_overlap", result.targetOverlap},
        {"inlier_distance_m", result.inlierDistance_m},
        {"voxel_schedule_m", result.voxelSchedule_m},
        {"levels", std::move(levels)},
        {"notes", result.notes},
        {"initial", {{"pose", rowMajor(result.initial.pose)}, {"scale", result.initial.scale}}}};
    if (withSeconds) object["seconds"] = result.seconds;
    object["verdict"] = std::string(describe(result.verdict));
    object["reasons"] = result.reasons;
    object["candidates"] = candidatesJson(result.candidates);
    object["covariance"] = nullptr;
    object["quality"] = nullptr;
    if (result.quality) {
        const Eigen::Vector3d translation = result.targetFromSource.pose.translation();
        object["covariance"] = rowMajor(result.quality->uncertainty.about(translation).covariance);
        object["quality"] = qualityJson(*result.quality);
    }
    return object;
}

nlohmann::json failedRegistrationJson(const std::string& method, const Error& error,
                                      const std::vector<PoseCandidate>& candidates) {
    RegistrationResult none;
    none.method = method;
    none.verdict = Verdict::failed;
    none.reasons = {error.sentence()};
    none.candidates = candidates;
    nlohmann::json object = registrationJson(none, true);
    for (const char* unknown : {"pose", "scale", "rmse_m", "overlap", "inlier_distance_m", "initial"})
        object[unknown] = nullptr;
    return object;
}

}  // namespace vestige
