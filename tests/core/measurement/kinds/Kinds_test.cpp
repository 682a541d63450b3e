#include <cmath>
#include <numbers>

#include "core/base/Random.h"
#include "tests/core/measurement/kinds/KindExamples.h"

using namespace vestige;
using namespace vestige::test;
using Kind = MeasurementKind;

namespace {

/// Far from the origin, as surveyed coordinates are.
const Eigen::Vector3d kFar(483'400.5, 4'375'661.25, 34.5);

std::vector<Eigen::Vector3d> far(std::vector<Eigen::Vector3d> points) {
    for (auto& point : points) point += kFar;
    return points;
}

std::vector<Eigen::Vector3d> onCircle(double radius, double from_rad, double to_rad, int count) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double angle = from_rad + (to_rad - from_rad) * i / (count - 1);
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    return points;
}

}  // namespace

TEST(KindTable, HasEveryKindOnceWithWhatItNeeds) {
    const auto& table = kindTable();
    EXPECT_EQ(table.size(), 14U);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const KindSpec& spec = table[i];
        EXPECT_EQ(static_cast<std::size_t>(spec.kind), i);
        EXPECT_EQ(&kindSpec(spec.kind), &spec);
        EXPECT_FALSE(spec.label.empty());
        EXPECT_TRUE(spec.meaning.ends_with(".")) << spec.meaning;
        EXPECT_TRUE(spec.most == 0 || spec.most >= spec.fewest);
        EXPECT_FALSE(spec.picks.empty());
        for (const ParameterSpec& parameter : *spec.parameters) {
            EXPECT_FALSE(parameter.label.empty()) << parameter.key;
            EXPECT_TRUE(parameter.help.ends_with(".")) << parameter.key;
        }
    }
}

TEST(KindTable, SettingsAreCheckedLikeAllParameters) {
    EXPECT_TRUE(kindSettings(Kind::arc, {{"drag_factor", 0.7}}));
    const auto unknown = kindSettings(Kind::arc, {{"drag", 0.7}});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().message, "there is no parameter 'drag'");
    EXPECT_FALSE(kindSettings(Kind::arc, {{"drag_factor", 7}}));
    EXPECT_FALSE(kindSettings(Kind::crush, {{"stations", 5.5}}));
    EXPECT_EQ(kindSettings(Kind::crush, {{"stations", 4}})->integer("stations"), 4);
    EXPECT_TRUE(kindSettings(Kind::volume, {{"level_base", 1}})->boolean("level_base"));
}

TEST(Separations, PartsOfOneWay) {
    const auto points = far({{0, 0, 0}, {3, 4, 12}});
    EXPECT_NEAR(valueOf(valuesOf(Kind::distance, points), "distance"), 13, 1e-8);
    const KindValues level = valuesOf(Kind::horizontal, points);
    EXPECT_EQ(level.quantities.front().key, "horizontal");
    EXPECT_NEAR(level.quantities.front().value, 5, 1e-8);
    EXPECT_NEAR(valuesOf(Kind::vertical, points).quantities.front().value, 12, 1e-8);
}

TEST(Separations, PointAndPlane) {
    // The plane x + y + z = 3, 3 / sqrt 3 from the origin.
    const auto values =
        valuesOf(Kind::pointToPlane, far({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 1, 1}}));
    EXPECT_NEAR(valueOf(values, "distance"), std::sqrt(3.0), 1e-8);
    EXPECT_NEAR(valueOf(values, "tilt"), std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi, 1e-6);
    EXPECT_EQ(whyNot(Kind::pointToPlane, {{0, 0, 1}, {0, 0, 0}, {1, 1, 0}, {2, 2, 0}}),
              "the points of the plane lie on one line");
}

TEST(Separations, TwoPlanes) {
    const auto values = valuesOf(
        Kind::planeToPlane, far({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2.5}, {1, 0, 2.5}, {5, 7, 2.5}}));
    EXPECT_NEAR(valueOf(values, "distance"), 2.5, 1e-8);
    EXPECT_NEAR(valueOf(values, "angle"), 0, 1e-6);
    const auto tilted =
        valuesOf(Kind::planeToPlane,
                 {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 2}, {0, 1, 1}, {1, 1, 2}}, {});
    EXPECT_NEAR(valueOf(tilted, "angle"), 45, 1e-9);
    EXPECT_EQ(whyNot(Kind::planeToPlane, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}}),
              "the second plane has fewer than three points");
}

TEST(Angle, BetweenLegsAndInPlan) {
    const auto values = valuesOf(Kind::angle, far({{1, 0, 0}, {0, 0, 0}, {1, 1, std::sqrt(2.0)}}));
    EXPECT_NEAR(valueOf(values, "angle"), 60, 1e-6);
    EXPECT_NEAR(valueOf(values, "angle_plan"), 45, 1e-6);
    EXPECT_NEAR(valueOf(valuesOf(Kind::angle, {{1, 0, 0}, {0, 0, 0}, {-1, 0, 0}}), "angle"), 180, 1e-9);
    EXPECT_EQ(valuesOf(Kind::angle, {{0, 0, 1}, {0, 0, 0}, {1, 0, 0}}).quantities.size(), 1U)
        << "an upright leg has no direction in plan";
    EXPECT_FALSE(whyNot(Kind::angle, {{1, 0, 0}, {1, 0, 0}, {2, 0, 0}}).empty());
}

TEST(Polyline, LengthPartsAndSkidSpeed) {
    const auto points = far({{0, 0, 0}, {3, 4, 0}, {3, 4, 12}, {3, 10, 12}});
    const auto values = valuesOf(Kind::polyline, points, {{"drag_factor", 0.7}});
    EXPECT_NEAR(valueOf(values, "length"), 5 + 12 + 6, 1e-8);
    EXPECT_NEAR(valueOf(values, "horizontal"), 11, 1e-8);
    EXPECT_NEAR(valueOf(values, "chord"), std::sqrt(9 + 100 + 144.0), 1e-8);
    EXPECT_NEAR(valueOf(values, "rise"), 12, 1e-8);
    // S = sqrt(30 d f) in feet and miles per hour, as the field's handbooks have it.
    const double feet = 23 / 0.3048;
    EXPECT_NEAR(valueOf(values, "speed") / 1.609344, std::sqrt(30 * feet * 0.7), 0.15);
    EXPECT_EQ(valuesOf(Kind::polyline, points).quantities.size(), 5U) << "no speed without a drag factor";
}

TEST(Arc, ChordFormulaOnTheCircle) {
    for (const double radius : {8.0, 60.0, 900.0}) {
        const double half = std::min(1.2, 20 / radius);
        auto points = onCircle(radius, 0.3 - half, 0.3 + half, 3);
        const auto values = valuesOf(Kind::arc, far(points));
        const double chord = 2 * radius * std::sin(half), m = radius * (1 - std::cos(half));
        EXPECT_NEAR(valueOf(values, "chord"), chord, 1e-7);
        EXPECT_NEAR(valueOf(values, "middle_ordinate"), m, 1e-6);
        EXPECT_NEAR(valueOf(values, "radius_chord"), chord * chord / (8 * m) + m / 2, 1e-3);
        EXPECT_NEAR(valueOf(values, "radius_chord"), radius, radius * 1e-5);
        EXPECT_NEAR(valueOf(values, "radius_fit"), radius, radius * 1e-5);
        EXPECT_NEAR(valueOf(values, "arc_length"), 2 * half * radius, 1e-5);
    }
    // A pick beside the chord's middle gives the same circle.
    const auto aside = valuesOf(Kind::arc, {{60, 0, 0},
                                            {60 * std::cos(0.1), 60 * std::sin(0.1), 0},
                                            {60 * std::cos(0.5), 60 * std::sin(0.5), 0}});
    EXPECT_NEAR(valueOf(aside, "radius_chord"), 60, 1e-9);
    EXPECT_NEAR(valueOf(aside, "middle_ordinate"), 60 * (1 - std::cos(0.25)), 1e-9);
    EXPECT_FALSE(whyNot(Kind::arc, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).empty());
    EXPECT_FALSE(whyNot(Kind::arc, {{0, 0, 0}, {1, 1, 0}, {0, 0, 0}}).empty());
}

TEST(Arc, CriticalSpeedAsPublishedInFeet) {
    // S = 3.86 sqrt(R f), miles per hour and feet.
    for (const double feet : {120.0, 200.0, 650.0}) {
        const auto values = valuesOf(Kind::arc, onCircle(feet * 0.3048, 0, 0.4, 9), {{"drag_factor", 0.7}});
        EXPECT_NEAR(valueOf(values, "speed_fit") / 1.609344 / (3.86 * std::sqrt(feet * 0.7)), 1, 0.003);
    }
    const auto banked =
        valuesOf(Kind::arc, onCircle(80.75, 0, 0.4, 9),
                 {{"drag_factor", 0.7}, {"superelevation_percent", 4}, {"half_track_m", 0.75}});
    EXPECT_NEAR(valueOf(banked, "speed_fit"), 3.6 * std::sqrt(9.80665 * 80 * (0.7 + 0.04) / (1 - 0.7 * 0.04)),
                1e-5);
}

TEST(Area, PlaneFigures) {
    const auto values = valuesOf(Kind::area, far({{0, 0, 0}, {3, 0, 4}, {3, 2, 4}, {0, 2, 0}}));
    EXPECT_NEAR(valueOf(values, "area"), 10, 1e-7);
    EXPECT_NEAR(valueOf(values, "area_plan"), 6, 1e-7);
    EXPECT_NEAR(valueOf(values, "perimeter"), 14, 1e-7);
    const auto notch = valuesOf(Kind::area, {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}});
    EXPECT_NEAR(valueOf(notch, "area"), 16 - 6, 1e-12);
}

TEST(Circle, RimInAnyPlane) {
    const Eigen::Vector3d u = Eigen::Vector3d(1, 2, 0.5).normalized();
    const Eigen::Vector3d v = u.cross(Eigen::Vector3d(0, 0, 1)).normalized();
    std::vector<Eigen::Vector3d> rim;
    for (const double angle : {0.1, 1.0, 2.2, 3.9, 5.0})
        rim.emplace_back(kFar + 0.32 * (std::cos(angle) * u + std::sin(angle) * v));
    const auto values = valuesOf(Kind::circle, rim);
    EXPECT_NEAR(valueOf(values, "diameter"), 0.64, 1e-7);
    EXPECT_NEAR(valueOf(values, "centre_height"), kFar.z(), 1e-7);
    EXPECT_NEAR(valueOf(values, "tilt"), std::acos(std::abs(u.cross(v).z())) * 180 / std::numbers::pi, 1e-5);
}

TEST(Box, TurnedBoxFromItsCorners) {
    const double turn = 0.7;
    std::vector<Eigen::Vector3d> corners;
    for (const double x : {0.0, 4.6})
        for (const double y : {0.0, 1.8})
            corners.emplace_back(kFar + Eigen::Vector3d(x * std::cos(turn) - y * std::sin(turn),
                                                        x * std::sin(turn) + y * std::cos(turn), 0));
    corners.emplace_back(0.5 * (corners[0] + corners[3]) + Eigen::Vector3d(0, 0, 1.45));
    const auto values = valuesOf(Kind::box, corners);
    EXPECT_NEAR(valueOf(values, "length"), 4.6, 1e-7);
    EXPECT_NEAR(valueOf(values, "width"), 1.8, 1e-7);
    EXPECT_NEAR(valueOf(values, "height"), 1.45, 1e-7);
    EXPECT_NEAR(valueOf(values, "volume"), 4.6 * 1.8 * 1.45, 1e-6);
    EXPECT_FALSE(whyNot(Kind::box, {{0, 0, 0}, {1, 0, 0}, {2, 0, 1}, {3, 0, 0}}).empty());
}
