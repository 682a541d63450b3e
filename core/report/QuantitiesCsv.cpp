#include "core/report/QuantitiesCsv.h"

#include <cmath>

#include "core/base/Csv.h"
#include "core/base/Numbers.h"

namespace vestige {
namespace {

std::string text(const std::optional<double>& value) {
    return value ? exactText(*value) : std::string();
}

}  // namespace

std::string quantitiesCsv(const MeasuredScene& measured) {
    std::string csv =
        csvLine({"object", "kind", "quantity", "unit", "method", "n", "mean", "sd", "standard_uncertainty",
                 "degrees_of_freedom", "expanded_uncertainty", "interval_low", "interval_high", "reference",
                 "error", "relative_error", "parameters"});
    for (const MeasuredKind& kind : measured.kinds)
        for (const QuantityStatistic& each : kind.quantities) {
            const std::string error = each.reference ? exactText(each.mean - *each.reference) : std::string();
            csv +=
                csvLine({kind.object, std::string(name(kind.kind)), each.key, std::string(symbol(each.unit)),
                         kind.method, std::to_string(each.repeats.size()), exactText(each.mean),
                         text(each.repeatSd), text(each.standardUncertainty), text(each.degreesOfFreedom),
                         text(each.expandedUncertainty), text(each.low), text(each.high),
                         text(each.reference), error, text(each.relativeError), kind.parameters});
        }
    return csv;
}

std::string uncertaintyCsv(const MeasuredScene& measured) {
    std::string csv = csvLine({"object", "kind", "quantity", "method", "source", "standard_uncertainty",
                               "unit", "sensitivity", "distribution", "degrees_of_freedom", "contribution",
                               "contribution_unit", "share"});
    for (const MeasuredKind& kind : measured.kinds)
        for (const QuantityStatistic& each : kind.quantities)
            for (const Contribution& line : each.budget.contributions)
                csv +=
                    csvLine({kind.object, std::string(name(kind.kind)), each.key, kind.method, line.source,
                             exactText(line.value), line.unit, exactText(line.sensitivity),
                             std::string(name(line.distribution)), exactText(line.degreesOfFreedom),
                             exactText(line.part()), std::string(symbol(each.unit)), exactText(line.share)});
    return csv;
}

}  // namespace vestige
