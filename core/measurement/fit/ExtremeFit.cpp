#include "core/measurement/fit/ExtremeFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace vestige {
namespace {

double cumulative(double x) {
    return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// Negative log likelihood of an end and a thickness, of values from `cut` up.
struct Likelihood {
    std::span<const double> values;
    double noise;
    double cut;
    double top;
    double strays;

    double operator()(double end, double thickness) const {
        const double wide = std::max(thickness, 0.05 * noise);
        // The share of the slab's values above the cut, by Simpson's rule.
        constexpr int kSteps = 16;
        double share = 0;
        for (int i = 0; i <= kSteps; ++i) {
            const double at = end - wide * i / kSteps;
            const double weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
            share += weight * cumulative((at - cut) / noise);
        }
        share /= 3 * kSteps;
        const double range = std::max(top - cut, noise);
        double sum = 0;
        for (const double value : values) {
            const double density =
                (cumulative((value - end + wide) / noise) - cumulative((value - end) / noise)) / wide;
            sum -= std::log((1 - strays) * density / std::max(share, 1e-12) + strays / range);
        }
        return sum;
    }
};

/// Of the values, which it sorts, the upper ones; nothing where these are too few.
std::optional<Likelihood> likelihoodOf(std::vector<double>& values, double noise, double strays) {
    constexpr std::size_t kLeast = 8;
    if (values.size() < kLeast || !(noise > 0)) return std::nullopt;
    std::sort(values.begin(), values.end());
    // What lies more than some noise below the end says nothing of it.
    const double top = values[static_cast<std::size_t>(0.97 * static_cast<double>(values.size() - 1))];
    const double cut = std::max(values.front(), top - 6 * noise);
    const auto first = std::lower_bound(values.begin(), values.end(), cut);
    const std::span<const double> upper(first, values.end());
    if (upper.size() < kLeast) return std::nullopt;
    return Likelihood{upper, noise, cut, values.back(), strays};
}

}  // namespace

std::optional<EndFit> upperEnd(std::vector<double> values, double noise, double strays) {
    const auto made = likelihoodOf(values, noise, strays);
    if (!made) return std::nullopt;
    const Likelihood& likelihood = *made;
    const std::span<const double> upper = likelihood.values;
    const double cut = likelihood.cut;

    // Nested search: thickness over a grid that is refined, the end by golden section within it.
    const auto bestEnd = [&](double thickness, double& at) {
        double low = cut;
        double high = values.back() + noise;
        constexpr double kGolden = 0.6180339887498949;
        double a = high - kGolden * (high - low);
        double b = low + kGolden * (high - low);
        double fa = likelihood(a, thickness);
        double fb = likelihood(b, thickness);
        for (int i = 0; i < 26; ++i) {
            if (fa < fb) {
                high = b;
                b = a;
                fb = fa;
                a = high - kGolden * (high - low);
                fa = likelihood(a, thickness);
            } else {
                low = a;
                a = b;
                fa = fb;
                b = low + kGolden * (high - low);
                fb = likelihood(b, thickness);
            }
        }
        at = 0.5 * (low + high);
        return std::min(fa, fb);
    };
    EndFit fit;
    double least = std::numeric_limits<double>::infinity();
    for (const double share : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0}) {
        double at = 0;
        const double value = bestEnd(share * noise, at);
        if (value >= least) continue;
        least = value;
        fit.place = at;
        fit.thickness = share * noise;
    }
    fit.used = upper.size();
    // Curvature of the likelihood along the end with the thickness following it.
    const double h = 0.3 * noise;
    const auto profile = [&](double end) {
        double best = std::numeric_limits<double>::infinity();
        for (const double share : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0})
            best = std::min(best, likelihood(end, share * noise));
        return best;
    };
    const double curvature = (profile(fit.place + h) - 2 * least + profile(fit.place - h)) / (h * h);
    const double floor = noise / std::sqrt(static_cast<double>(upper.size()));
    fit.standardUncertainty = curvature > 0 ? std::clamp(1 / std::sqrt(curvature), floor, 2 * noise) : noise;
    return fit;
}

std::optional<EndFit> meanUpperEnd(std::vector<double> values, double noise, double strays) {
    const auto likelihood = likelihoodOf(values, noise, strays);
    if (!likelihood) return std::nullopt;
    constexpr int kThicknesses = 13;
    constexpr int kPlaces = 61;
    constexpr double kStep = 0.1;  // of the noise, from place to place
    const double top = values[static_cast<std::size_t>(0.97 * static_cast<double>(values.size() - 1))];
    struct Case {
        double place, thickness, misfit;
    };
    std::vector<Case> cases;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kThicknesses; ++i) {
        const double thickness = 0.25 * i * noise;
        for (int k = 0; k < kPlaces; ++k) {
            const double place = top + noise * (kStep * k - 4.5);
            const double misfit = (*likelihood)(place, thickness) + 0.25 * i;
            cases.push_back({place, thickness, misfit});
            least = std::min(least, misfit);
        }
    }
    EndFit fit;
    double sum = 0;
    double squares = 0;
    for (const Case& each : cases) {
        const double weight = std::exp(least - each.misfit);
        sum += weight;
        fit.place += weight * each.place;
        fit.thickness += weight * each.thickness;
        squares += weight * (each.place - top) * (each.place - top);
    }
    fit.place /= sum;
    fit.thickness /= sum;
    // All the weight on one place: it is still known no better than the places lie apart.
    const double spread = squares / sum - (fit.place - top) * (fit.place - top);
    const double step = kStep * noise;
    fit.standardUncertainty = std::sqrt(step * step / 12 + std::max(0.0, spread));
    fit.used = likelihood->values.size();
    return fit;
}

}  // namespace vestige
