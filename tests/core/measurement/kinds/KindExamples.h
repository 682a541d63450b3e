#pragma once

#include <gtest/gtest.h>

#include "core/measurement/kinds/KindStatistics.h"

namespace vestige::test {

inline std::vector<KindEnd> endsAt(const std::vector<Eigen::Vector3d>& points, double noise_m = 0) {
    std::vector<KindEnd> ends;
    for (const auto& point : points) ends.push_back({point, noise_m, 0});
    return ends;
}

/// The figures of one repeat, which must be measurable.
inline KindValues valuesOf(MeasurementKind kind, const std::vector<Eigen::Vector3d>& points,
                           const std::map<std::string, double>& settings = {},
                           const std::vector<Eigen::Vector3d>& cloud = {}) {
    const auto set = kindSettings(kind, settings);
    EXPECT_TRUE(set) << (set ? "" : set.error().sentence());
    const auto ends = endsAt(points);
    const auto values = kindSpec(kind).evaluate({ends, *set, cloud, 0});
    EXPECT_TRUE(values) << (values ? "" : values.error().sentence());
    return values.value_or(KindValues{});
}

inline double valueOf(const KindValues& values, const std::string& key) {
    for (const auto& quantity : values.quantities)
        if (quantity.key == key) return quantity.value;
    ADD_FAILURE() << "no " << key;
    return 0;
}

inline QuantityStatistic statisticOf(const KindOutcome& outcome, const std::string& key) {
    for (const auto& quantity : outcome.quantities)
        if (quantity.key == key) return quantity;
    ADD_FAILURE() << "no " << key;
    return {};
}

inline std::string whyNot(MeasurementKind kind, const std::vector<Eigen::Vector3d>& points) {
    const auto set = kindSettings(kind, {});
    const auto ends = endsAt(points);
    const auto values = kindSpec(kind).evaluate({ends, *set});
    return values ? std::string() : values.error().message;
}

}  // namespace vestige::test
