#include "core/report/ChecksJson.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace vestige {
namespace {

using nlohmann::json;

json number(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? json(*value) : json(nullptr);
}

json budgetJson(const Budget& budget) {
    json list = json::array();
    for (const Contribution& each : budget.contributions)
        list.push_back({{"source", each.source},
                        {"standard_uncertainty", each.value},
                        {"unit", each.unit},
                        {"sensitivity", each.sensitivity},
                        {"distribution", std::string(name(each.distribution))},
                        {"degrees_of_freedom", number(each.degreesOfFreedom)},
                        {"share", each.share}});
    return list;
}

}  // namespace

json quantitiesJson(const MeasuredScene& measured) {
    json list = json::array();
    for (const MeasuredKind& kind : measured.kinds)
        for (const QuantityStatistic& each : kind.quantities)
            list.push_back({{"object", kind.object},
                            {"kind", std::string(name(kind.kind))},
                            {"quantity", each.key},
                            {"unit", std::string(symbol(each.unit))},
                            {"method", kind.method},
                            {"repeats", each.repeats},
                            {"mean", each.mean},
                            {"sd", number(each.repeatSd)},
                            {"standard_uncertainty", number(each.standardUncertainty)},
                            {"degrees_of_freedom", number(each.degreesOfFreedom)},
                            {"expanded_uncertainty", number(each.expandedUncertainty)},
                            {"interval", {number(each.low), number(each.high)}},
                            {"reference", number(each.reference)},
                            {"relative_error", number(each.relativeError)},
                            {"parameters", kind.parameters},
                            {"budget", budgetJson(each.budget)}});
    return list;
}

json checksJson(const MeasuredScene& measured) {
    json list = json::array();
    for (const DistanceCheck& check : measured.checks)
        list.push_back({{"object", check.object},
                        {"method", check.method},
                        {"reference_m", check.reference_m},
                        {"tolerance_m", check.tolerance_m},
                        {"measured_m", number(check.measured_m)},
                        {"expanded_uncertainty_m", number(check.expandedUncertainty_m)},
                        {"difference_m", number(check.difference_m)},
                        {"verdict", std::string(name(check.verdict))},
                        {"note", check.note}});
    return {{"verification", std::string(name(verification(measured)))},
            {"known_distances", std::move(list)}};
}

}  // namespace vestige
