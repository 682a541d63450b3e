#include "core/report/AccuracyCsv.h"

#include "core/base/Csv.h"
#include "core/base/Numbers.h"

namespace vestige {

std::string accuracyCsv(std::span<const MethodAccuracy> methods) {
    const auto text = [](const std::optional<double>& value) {
        return value ? exactText(*value) : std::string();
    };
    std::string csv = csvLine({"method", "n", "sd", "rmse", "rmse_all", "rmse_abs_m", "excluded"});
    for (const auto& method : methods) {
        std::string excluded;
        for (const auto& object : method.excluded) excluded += (excluded.empty() ? "" : ";") + object;
        csv += csvLine({method.name, std::to_string(method.n), text(method.sd), text(method.rmse),
                        text(method.rmseAll), text(method.rmseAbsolute_m), excluded});
    }
    return csv;
}

}  // namespace vestige
