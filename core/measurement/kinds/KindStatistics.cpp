#include "core/measurement/kinds/KindStatistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/CancelScope.h"

namespace vestige {
namespace {

constexpr double kSmallestStep_m = 1e-6;

double square(double x) {
    return x * x;
}

const QuantityValue* find(const KindValues& values, const std::string& key) {
    for (const QuantityValue& quantity : values.quantities)
        if (quantity.key == key) return &quantity;
    return nullptr;
}

/// Derivatives of every quantity (in the order of `values`) by the coordinates of every pick: a row of three
/// per pick.
std::vector<std::vector<Eigen::Vector3d>> gradients(const KindSpec& spec, const KindRepeat& repeat,
                                                    const ParameterSet& settings, const KindValues& values) {
    std::vector<std::vector<Eigen::Vector3d>> result(
        values.quantities.size(), std::vector<Eigen::Vector3d>(repeat.ends.size(), Eigen::Vector3d::Zero()));
    std::vector<KindEnd> moved = repeat.ends;
    const auto evaluated = [&] { return spec.evaluate(repeat.input(moved, settings)); };
    for (std::size_t i = 0; i < moved.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            throwIfCancelled();
            const double held = moved[i].position[axis];
            const double step = std::max(kSmallestStep_m, moved[i].standard_m());
            moved[i].position[axis] = held + step;
            const auto above = evaluated();
            moved[i].position[axis] = held - step;
            const auto below = evaluated();
            moved[i].position[axis] = held;
            if (!above || !below) continue;
            for (std::size_t q = 0; q < result.size(); ++q) {
                const std::string& key = values.quantities[q].key;
                const QuantityValue* up = find(*above, key);
                const QuantityValue* down = find(*below, key);
                if (up && down) result[q][i][axis] = (up->value - down->value) / (2 * step);
            }
        }
    }
    return result;
}

/// Mean squares over the repeats, by source, in the order in which they came up.
class Shares {
  public:
    /// `squared` in the result's unit; `value` the standard uncertainty of the input.
    void add(const std::string& source, const std::string& unit, double squared, double value,
             Distribution distribution, double degrees) {
        for (Share& share : shares_) {
            if (share.contribution.source != source) continue;
            share.squared += squared;
            share.valueSquared += square(value);
            return;
        }
        Contribution contribution{source, 0, unit, 1, distribution, degrees, 0};
        shares_.push_back({std::move(contribution), squared, square(value)});
    }
    void add(const Contribution& own) {
        add(own.source, own.unit, square(own.part()), own.value, own.distribution, own.degreesOfFreedom);
    }

    /// `unit` is that of the result.
    std::vector<Contribution> contributions(std::size_t repeats, QuantityUnit unit) const {
        std::vector<Contribution> result;
        for (const Share& share : shares_) {
            Contribution contribution = share.contribution;
            const auto n = static_cast<double>(repeats);
            contribution.value = std::sqrt(share.valueSquared / n);
            const double part = std::sqrt(share.squared / n);
            if (contribution.value > 0) {
                contribution.sensitivity = part / contribution.value;
            } else {
                contribution.value = part;
                contribution.unit = std::string(symbol(unit));
                contribution.sensitivity = 1;
            }
            result.push_back(std::move(contribution));
        }
        return result;
    }

  private:
    struct Share {
        Contribution contribution;
        double squared = 0;
        double valueSquared = 0;
    };
    std::vector<Share> shares_;
};

void addPicks(Shares& shares, const KindRepeat& repeat, const std::vector<Eigen::Vector3d>& gradient) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double noise = 0, spacing = 0, fit = 0;        // in the result
    double noiseIn = 0, spacingIn = 0, fitIn = 0;  // of the picks
    std::size_t measured = 0, fitted = 0;
    for (std::size_t i = 0; i < repeat.ends.size(); ++i) {
        const KindEnd& end = repeat.ends[i];
        const Eigen::Vector3d& g = gradient[i];
        if (end.covariance) {
            fit += std::max(0.0, g.dot(*end.covariance * g));
            fitIn += end.covariance->trace() / 3;
            ++fitted;
            continue;
        }
        noise += g.squaredNorm() * square(end.noise_m);
        spacing += g.squaredNorm() * square(end.spacing_m) / 12;
        noiseIn += square(end.noise_m);
        spacingIn += square(end.spacing_m) / 12;
        ++measured;
    }
    const auto rms = [](double sum, std::size_t count) {
        return std::sqrt(sum / static_cast<double>(count));
    };
    if (measured > 0) {
        shares.add("sensor noise", "m", noise, rms(noiseIn, measured), Distribution::normal, kInfinity);
        shares.add("point spacing", "m", spacing, rms(spacingIn, measured), Distribution::rectangular,
                   kInfinity);
    }
    if (fitted > 0)
        shares.add("fitted features", "m", fit, rms(fitIn, fitted), Distribution::normal, kInfinity);
}

/// Each scan may be off by one rigid motion: t + w x (p - pivot) at each of its picks.
void addPoses(Shares& shares, const KindSpec& spec, const KindMeasurement& measurement,
              const KindRepeat& repeat, const std::vector<Eigen::Vector3d>& gradient) {
    const bool oneBody = std::all_of(repeat.ends.begin(), repeat.ends.end(), [&](const KindEnd& end) {
        return end.body == repeat.ends.front().body;
    });
    // Distances and angles within one rigid body do not depend on where it lies.
    if (oneBody && !spec.usesVertical) return;
    for (std::size_t b = 0; b < measurement.bodies.size(); ++b) {
        const KindBody& body = measurement.bodies[b];
        if (!body.pose) continue;
        Vector6d along = Vector6d::Zero();
        double moved = 0;  // mean square of where the scan's pose puts a pick, along one axis
        std::size_t touched = 0;
        for (std::size_t i = 0; i < repeat.ends.size(); ++i) {
            if (repeat.ends[i].body != b) continue;
            ++touched;
            const Eigen::Vector3d lever = repeat.ends[i].position - body.pose->pivot_m;
            along.head<3>() += gradient[i];
            along.tail<3>() += lever.cross(gradient[i]);
            moved += body.pose->at(repeat.ends[i].position).trace() / 3;
        }
        if (touched == 0) continue;
        const double squared = std::max(0.0, along.dot(body.pose->covariance * along));
        const double value = std::sqrt(std::max(0.0, moved / static_cast<double>(touched)));
        shares.add("registration of " + body.name, "m", squared, value, Distribution::normal,
                   std::numeric_limits<double>::infinity());
    }
}

void fillInterval(QuantityStatistic& statistic, int power) {
    const double u = statistic.budget.expanded;
    statistic.low = statistic.mean - u;
    statistic.high = statistic.mean + u;
    if (power == 1 || !(statistic.mean > 0)) return;
    const double centre = std::pow(statistic.mean, power);
    const double reach = std::abs(power) * centre / statistic.mean * u;
    statistic.low = std::pow(centre + reach, 1.0 / power);
    statistic.high =
        centre > reach ? std::pow(centre - reach, 1.0 / power) : std::numeric_limits<double>::infinity();
}

QuantityStatistic statisticOf(const QuantityValue& first, const std::vector<double>& repeats,
                              const Shares& shares) {
    QuantityStatistic statistic{first.key, first.label, first.unit, repeats};
    const auto n = static_cast<double>(repeats.size());
    for (const double value : repeats) statistic.mean += value / n;
    std::vector<Contribution> contributions;
    if (repeats.size() > 1) {
        double squares = 0;
        for (const double value : repeats) squares += square(value - statistic.mean);
        statistic.repeatSd = std::sqrt(squares / (n - 1));
        contributions.push_back({"repeats", *statistic.repeatSd / std::sqrt(n),
                                 std::string(symbol(first.unit)), 1, Distribution::student, n - 1, 0});
    }
    for (Contribution& each : shares.contributions(repeats.size(), first.unit))
        contributions.push_back(std::move(each));
    statistic.budget = combined(std::move(contributions));
    if (repeats.size() < 2 && !first.selfContained) return statistic;
    statistic.standardUncertainty = statistic.budget.standard;
    statistic.degreesOfFreedom = statistic.budget.degreesOfFreedom;
    statistic.expandedUncertainty = statistic.budget.expanded;
    fillInterval(statistic, first.intervalPower);
    return statistic;
}

}  // namespace

double KindEnd::standard_m() const {
    if (covariance) return std::sqrt(std::max(0.0, covariance->trace() / 3));
    return std::hypot(noise_m, spacing_m / std::sqrt(12.0));
}

KindOutcome kindStatistics(const KindMeasurement& measurement) {
    KindOutcome outcome;
    const KindSpec& spec = kindSpec(measurement.kind);
    const auto settings = kindSettings(measurement.kind, measurement.settings);
    if (!settings) {
        outcome.notes.push_back(settings.error().sentence());
        return outcome;
    }
    struct Evaluated {
        const KindRepeat* repeat;
        KindValues values;
        std::vector<std::vector<Eigen::Vector3d>> gradients;
    };
    std::vector<Evaluated> all;
    for (std::size_t r = 0; r < measurement.repeats.size(); ++r) {
        const KindRepeat& repeat = measurement.repeats[r];
        auto values = spec.evaluate(repeat.input(repeat.ends, *settings));
        if (!values) {
            outcome.notes.push_back("repeat " + std::to_string(r + 1) + ": " + values.error().message);
            continue;
        }
        auto slopes = gradients(spec, repeat, *settings, *values);
        all.push_back({&repeat, std::move(*values), std::move(slopes)});
    }
    if (all.empty()) return outcome;
    for (const QuantityValue& first : all.front().values.quantities) {
        std::vector<double> repeats;
        Shares shares;
        QuantityValue shown = first;
        for (const Evaluated& each : all) {
            const QuantityValue* found = find(each.values, first.key);
            if (!found) continue;
            const auto q = static_cast<std::size_t>(found - each.values.quantities.data());
            repeats.push_back(found->value);
            shown.selfContained = shown.selfContained && found->selfContained;
            addPicks(shares, *each.repeat, each.gradients[q]);
            addPoses(shares, spec, measurement, *each.repeat, each.gradients[q]);
            for (const Contribution& own : found->own) shares.add(own);
        }
        outcome.quantities.push_back(statisticOf(shown, repeats, std::move(shares)));
    }
    outcome.series = all.back().values.series;
    return outcome;
}

}  // namespace vestige
