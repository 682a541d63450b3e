#include "core/measurement/Accuracy.h"

#include <cmath>
#include <utility>

#include "core/measurement/Length.h"

namespace vestige {
namespace {

std::optional<double> rootMeanSquare(std::span<const double> values) {
    if (values.empty()) return std::nullopt;
    double sum = 0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

double mean(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

std::optional<double> sampleSd(std::span<const double> values, double centre) {
    if (values.size() < 2) return std::nullopt;
    double sum = 0;
    for (const double value : values) sum += (value - centre) * (value - centre);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// One pass of |RE| > 2 SD; marks nothing when it would take half of the objects or more.
void markExcluded(MethodAccuracy& method) {
    if (method.n < 3) return;
    const auto beyond = [&](const AccuracyObject& object) {
        return object.re && std::abs(*object.re) > 2 * *method.sd;
    };
    std::size_t count = 0;
    for (const auto& object : method.objects) count += beyond(object) ? 1 : 0;
    method.systematic = 2 * count >= method.n;
    if (method.systematic) return;
    for (auto& object : method.objects) {
        object.excluded = beyond(object);
        if (object.excluded) method.excluded.push_back(object.object);
    }
}

}  // namespace

MethodAccuracy methodAccuracy(std::string name, std::span<const AccuracyObject> objects) {
    MethodAccuracy method;
    method.name = std::move(name);
    method.objects.assign(objects.begin(), objects.end());
    std::vector<double> relative;
    std::vector<double> absolute;
    std::vector<double> large;
    for (auto& object : method.objects) {
        object.excluded = false;
        object.re = object.measured_m ? relativeError(*object.measured_m, object.tape_m) : std::nullopt;
        if (!object.re) continue;
        relative.push_back(*object.re);
        if (object.small)
            method.small.push_back(object.object);
        else
            large.push_back(*object.re);
        absolute.push_back(*object.measured_m - object.tape_m);
    }
    method.n = relative.size();
    method.meanRe = mean(relative);
    method.sd = sampleSd(relative, method.meanRe);
    method.rmseAll = rootMeanSquare(relative);
    method.rmseLarge = rootMeanSquare(large);
    method.rmseAbsolute_m = rootMeanSquare(absolute);
    markExcluded(method);

    std::vector<double> kept;
    for (const auto& object : method.objects)
        if (object.re && !object.excluded) kept.push_back(*object.re);
    method.rmse = rootMeanSquare(kept);
    return method;
}

}  // namespace vestige
