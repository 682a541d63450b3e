#include "core/measurement/kinds/Budget.h"

#include <cmath>

#include "core/measurement/Length.h"

namespace vestige {

std::string_view name(Distribution distribution) {
    switch (distribution) {
        case Distribution::normal:
            return "normal";
        case Distribution::rectangular:
            return "rectangular";
        case Distribution::student:
            return "t";
    }
    return "normal";
}

double Contribution::part() const {
    return std::abs(sensitivity) * value;
}

Budget combined(std::vector<Contribution> contributions) {
    Budget budget;
    double variance = 0;
    double overDegrees = 0;
    for (const Contribution& each : contributions) {
        const double square = each.part() * each.part();
        variance += square;
        if (std::isfinite(each.degreesOfFreedom)) overDegrees += square * square / each.degreesOfFreedom;
    }
    budget.standard = std::sqrt(variance);
    if (overDegrees > 0) budget.degreesOfFreedom = variance * variance / overDegrees;
    for (Contribution& each : contributions)
        each.share = variance > 0 ? each.part() * each.part() / variance : 0;
    budget.coverageFactor = studentQuantile975(budget.degreesOfFreedom);
    budget.expanded = budget.coverageFactor * budget.standard;
    budget.contributions = std::move(contributions);
    return budget;
}

}  // namespace vestige
