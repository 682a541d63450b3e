#include "core/measurement/MeasuredText.h"

#include <cmath>

#include "core/base/Numbers.h"

namespace vestige {
namespace {

constexpr int kWithout = 3;
constexpr int kFinest = 4;

bool isKnown(const std::optional<double>& uncertainty) {
    return uncertainty && *uncertainty > 0 && std::isfinite(*uncertainty);
}

/// Of two significant digits; 0.0996 becomes 0.10, not 0.100.
int twoDigits(double uncertainty) {
    const int decimals = 1 - static_cast<int>(std::floor(std::log10(uncertainty)));
    return std::round(uncertainty * std::pow(10.0, decimals)) >= 100 ? decimals - 1 : decimals;
}

std::string uncertaintyDigits(double uncertainty, int decimals) {
    if (twoDigits(uncertainty) <= kFinest) return fixedText(uncertainty, decimals);
    const double place = std::pow(10.0, kFinest);
    return fixedText(std::ceil(uncertainty * place - 1e-9) / place, kFinest);
}

}  // namespace

int measuredDecimals(std::optional<double> expandedUncertainty_m) {
    if (!isKnown(expandedUncertainty_m)) return kWithout;
    const int decimals = twoDigits(*expandedUncertainty_m);
    return decimals < 0 ? 0 : decimals > kFinest ? kFinest : decimals;
}

MeasuredText measuredText(double metres, std::optional<double> expandedUncertainty_m) {
    const int decimals = measuredDecimals(expandedUncertainty_m);
    MeasuredText text{fixedText(metres, decimals), {}};
    if (isKnown(expandedUncertainty_m))
        text.uncertainty = uncertaintyDigits(*expandedUncertainty_m, decimals);
    return text;
}

std::string measuredSentence(double metres, std::optional<double> expandedUncertainty_m) {
    const MeasuredText text = measuredText(metres, expandedUncertainty_m);
    return text.value + " m" + (text.uncertainty.empty() ? "" : " \u00b1 " + text.uncertainty + " m");
}

}  // namespace vestige
