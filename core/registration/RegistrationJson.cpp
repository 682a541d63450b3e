#include "core/registration/RegistrationJson.h"

#include <nlohmann/json.hpp>

namespace vestige {

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
        {"inlier_distance_m", result.inlierDistance_m},
        {"voxel_schedule_m", result.voxelSchedule_m},
        {"levels", std::move(levels)},
        {"notes", result.notes},
        {"initial", {{"pose", rowMajor(result.initial.pose)}, {"scale", result.initial.scale}}}};
    if (withSeconds) object["seconds"] = result.seconds;
    object["verdict"] = std::string(describe(result.verdict));
    object["reasons"] = result.reasons;
    return object;
}

}  // namespace vestige
