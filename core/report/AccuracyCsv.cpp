#include "core/report/AccuracyCsv.h"

#include "core/base/Csv.h"
#include "core/base/Numbers.h"

namespace vestige {

std::string accuracyCsv(std::span<const MethodAccuracy> methods) {
    const auto text = [](const std::optional<double>& value) {
        return value ? exactText(*value) : std::string();
    };
    std::string csv =
        csvLine({"method", "n", "sd", "rmse", "rmse_all", "rmse_abs_m", "excluded", "rmse_large", "small"});
    const auto joined = [](const std::vector<std::string>& objects) {
        std::string names;
        for (const auto& object : objects) names += (names.empty() ? "" : ";") + object;
        return names;
    };
    for (const auto& method : methods) {
        csv += csvLine({method.name, std::to_string(method.n), text(method.sd), text(method.rmse),
                        text(method.rmseAll), text(method.rmseAbsolute_m), joined(method.excluded),
                        text(method.rmseLarge), joined(method.small)});
    }
    return csv;
}

}  // namespace vestige
