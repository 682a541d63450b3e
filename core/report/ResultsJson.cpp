#include "core/report/ResultsJson.h"

#include <nlohmann/json.hpp>

namespace vestige {
namespace {

using nlohmann::json;

json number(const std::optional<double>& value) {
    return value ? json(*value) : json(nullptr);
}

}  // namespace

json accuracyJson(std::span<const MethodAccuracy> methods) {
    json list = json::array();
    for (const auto& method : methods) {
        json objects = json::array();
        for (const auto& object : method.objects)
            objects.push_back({{"object", object.object},
                               {"tape_m", object.tape_m},
                               {"measured_m", number(object.measured_m)},
                               {"re", number(object.re)},
                               {"excluded", object.excluded},
                               {"small", object.small}});
        list.push_back({{"name", method.name},
                        {"n", method.n},
                        {"sd", number(method.sd)},
                        {"rmse", number(method.rmse)},
                        {"rmse_all", number(method.rmseAll)},
                        {"rmse_large", number(method.rmseLarge)},
                        {"rmse_abs_m", number(method.rmseAbsolute_m)},
                        {"systematic", method.systematic},
                        {"excluded", method.excluded},
                        {"small", method.small},
                        {"objects", std::move(objects)}});
    }
    return list;
}

json measurementsJson(const MeasuredScene& measured) {
    json list = json::array();
    for (const auto& length : measured.lengths) {
        const auto& statistic = length.length;
        list.push_back(
            {{"object", length.object},
             {"method", length.method},
             {"tape_m", number(length.tape_m)},
             {"measured_m", statistic ? json(statistic->repeats_m) : json::array()},
             {"measured_mean_m", statistic ? json(statistic->mean_m) : json(nullptr)},
             {"repeat_sd_m", statistic ? number(statistic->repeatSd_m) : json(nullptr)},
             {"expanded_uncertainty_m", statistic ? number(statistic->expandedUncertainty_m) : json(nullptr)},
             {"re", number(length.re)},
             {"excluded", length.excluded},
             {"fitted", length.fitted},
             {"small", length.small},
             {"layers", length.layers},
             {"note", length.note}});
    }
    return list;
}

}  // namespace vestige
