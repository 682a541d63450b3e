#include "core/report/BudgetBlocks.h"

#include <cmath>

#include "core/base/Numbers.h"
#include "core/report/QuantityText.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

/// Four significant digits without an exponent.
std::string significant(double value) {
    if (value == 0) return "0";
    if (!std::isfinite(value)) return "\u221e";
    const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return fixedText(value, std::min(9, std::max(0, 4 - before)));
}

std::string degreesText(double degrees) {
    return std::isfinite(degrees) ? fixedText(degrees, degrees < 100 ? 1 : 0) : "\u221e";
}

Table tableOf(const MeasuredKind& kind, const QuantityStatistic& main) {
    const std::string unit(symbol(main.unit));
    Table table;
    table.caption = kind.object + ", " + kind.method + ": " + main.label + " " + quantitySentence(main) +
                    ", u = " + inputText(main.budget.standard, unit);
    if (main.expandedUncertainty)
        table.caption += ", \u03bd = " + degreesText(main.budget.degreesOfFreedom) +
                         ", k = " + fixedText(main.budget.coverageFactor, 2);
    table.columns = {"Source",      "u of the input",  "Distribution", "\u03bd",
                     "Sensitivity", "u of the figure", "Share (%)"};
    table.numeric = {false, true, false, true, true, true, true};
    for (const Contribution& each : main.budget.contributions)
        table.rows.push_back({each.source, inputText(each.value, each.unit),
                              std::string(name(each.distribution)), degreesText(each.degreesOfFreedom),
                              significant(each.sensitivity), inputText(each.part(), unit),
                              fixedText(100 * each.share, 1)});
    return table;
}

}  // namespace

std::string inputText(double value, const std::string& unit) {
    if (unit == "m" && std::abs(value) < 1) return fixedText(1000 * value, 2) + " mm";
    return significant(value) + (unit.empty() ? "" : " " + unit);
}

void addBudgets(Section& section, const MeasuredScene& measured) {
    bool first = true;
    for (const MeasuredKind& kind : measured.kinds) {
        if (kind.quantities.empty()) continue;
        if (first)
            section.blocks.push_back(Paragraph{
                "The budgets below list what the uncertainty of each object\u2019s main figure is made of. "
                "The sensitivity says by how much the figure changes when the input does; the share is that "
                "of the combined variance u\u00b2. Those of all figures are in the file uncertainty.csv."});
        first = false;
        section.blocks.push_back(tableOf(kind, kind.quantities.front()));
    }
}

}  // namespace vestige
