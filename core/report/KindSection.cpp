#include <algorithm>

#include "core/base/Numbers.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/report/CaseReport.h"
#include "core/report/QuantityText.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

/// Distances stand in the table of lengths already.
bool isTold(const MeasuredKind& kind, MeasurementKind wanted) {
    return kind.kind == wanted && wanted != MeasurementKind::distance && !kind.quantities.empty();
}

bool isNothing(const ParameterValue& value) {
    if (const auto* real = std::get_if<double>(&value)) return *real == 0;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole == 0;
    if (const auto* on = std::get_if<bool>(&value)) return !*on;
    return std::holds_alternative<std::monostate>(value);
}

Table tableOf(const MeasuredScene& measured, const KindSpec& spec) {
    Table table;
    table.caption = spec.label + ": " + spec.meaning;
    table.columns = {"Object", "Method",        "Figure",    "Mean",  "n",
                     "U 95 %", "95 % interval", "Reference", "RE (%)"};
    table.numeric = {false, false, false, true, true, true, true, true, true};
    for (const MeasuredKind& kind : measured.kinds) {
        if (!isTold(kind, spec.kind)) continue;
        for (std::size_t i = 0; i < kind.quantities.size(); ++i) {
            const QuantityStatistic& each = kind.quantities[i];
            const std::string uncertainty = quantityUncertaintyText(each);
            table.rows.push_back(
                {i == 0 ? kind.object : "", i == 0 ? kind.method : "", each.label,
                 quantityValueText(each) + " " + std::string(readableSymbol(each.unit)),
                 std::to_string(each.repeats.size()),
                 each.expandedUncertainty ? "\u00b1" + uncertainty : uncertainty, quantityIntervalText(each),
                 orDash(each.reference ? std::optional(exactText(*each.reference)) : std::nullopt),
                 each.relativeError ? signedPercent(*each.relativeError) : "\u2013"});
        }
    }
    return table;
}

/// What the figures were found with. Not told is what nothing was given for.
Table parameterTable(const ReportInput& input, const KindSpec& spec) {
    Table table;
    table.caption = "Found with";
    table.columns = {"Object", "Parameter", "Value"};
    table.numeric = {false, false, true};
    for (const Measurement& measurement : input.scene.measurements) {
        const auto settings = kindSettings(measurement.kind, measurement.settings);
        const bool told = std::any_of(input.measured.kinds.begin(), input.measured.kinds.end(),
                                      [&](const MeasuredKind& kind) {
                                          return kind.object == measurement.object && isTold(kind, spec.kind);
                                      });
        if (!told || measurement.kind != spec.kind || !settings) continue;
        bool first = true;
        const auto known = [&](const char* key) {
            return settings->find(key) && !isNothing(settings->value(key));
        };
        for (const ParameterSpec& each : settings->table()) {
            if (each.key.starts_with("reference") || isNothing(settings->value(each.key))) continue;
            if (each.key == "drag_factor_range" && !known("drag_factor")) continue;
            table.rows.push_back({first ? measurement.object : "", each.label, settings->display(each.key)});
            first = false;
        }
    }
    return table;
}

Diagram diagramOf(const MeasuredKind& kind) {
    Diagram diagram;
    const bool crush = kind.kind == MeasurementKind::crush;
    diagram.caption = kind.object + ", " + kind.method +
                      (crush ? ": crush in plan, last repeat" : ": cross-section, last repeat");
    diagram.xName = crush ? "Along the damage (m)" : "Along the section (m)";
    diagram.yName = crush ? "Depth (m)" : "Height (m)";
    for (const KindSeries& series : kind.series)
        diagram.series.push_back({series.name, series.points, crush && series.name == "damaged"});
    return diagram;
}

}  // namespace

Section kindSection(const ReportInput& input) {
    Section section{"Other figures", {}};
    for (const KindSpec& spec : kindTable()) {
        const auto& kinds = input.measured.kinds;
        if (std::none_of(kinds.begin(), kinds.end(),
                         [&](const MeasuredKind& kind) { return isTold(kind, spec.kind); }))
            continue;
        section.blocks.push_back(tableOf(input.measured, spec));
        if (Table table = parameterTable(input, spec); !table.rows.empty())
            section.blocks.push_back(std::move(table));
        for (const MeasuredKind& kind : kinds) {
            if (!isTold(kind, spec.kind)) continue;
            if (!kind.series.empty()) section.blocks.push_back(diagramOf(kind));
        }
        if (spec.isPair()) continue;
        for (const ReportPicture& picture : input.pictures) {
            const Measurement* shown = input.scene.measurement(picture.subject);
            if (picture.kind == ReportPicture::Kind::closeUp && shown && shown->kind == spec.kind)
                section.blocks.push_back(Picture{picture.png, picture.caption, 0.5});
        }
    }
    return section;
}

}  // namespace vestige
