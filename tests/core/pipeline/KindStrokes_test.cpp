#include "core/pipeline/KindStrokes.h"

#include <gtest/gtest.h>

#include "core/pipeline/KindPaths.h"
#include "core/scene/MeasuredScene.h"

namespace vestige {
namespace {

using Vec = Eigen::Vector3d;

const std::vector<Vec> kPlane{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};

double lengthOf(const KindStroke& stroke) {
    return (stroke.points.back() - stroke.points.front()).norm();
}

TEST(KindStrokes, ADistanceToAPlaneIsItsPerpendicular) {
    std::vector<Vec> picks{{5, 5, 3}};
    picks.insert(picks.end(), kPlane.begin(), kPlane.end());
    const auto strokes = strokesOf(MeasurementKind::pointToPlane, {}, picks);
    ASSERT_EQ(strokes.size(), 2U);
    EXPECT_NEAR(lengthOf(strokes[0]), 3, 1e-12);
    EXPECT_LT((strokes[0].points[1] - Vec(5, 5, 0)).norm(), 1e-12);
    EXPECT_TRUE(strokes[1].closed);
    EXPECT_EQ(strokes[1].points, kPlane);
}

TEST(KindPaths, APathWithoutFeaturesIsDrawnUnderTheFittedMethodByItsPoints) {
    SceneState scene;
    Layer layer;
    layer.id = "aerial";
    layer.role = LayerRole::aerial;
    layer.method = "lidar";
    scene.layers.push_back(layer);
    scene.target = "aerial";
    Measurement plain;
    plain.object = "plain";
    plain.kind = MeasurementKind::polyline;
    PickedPath path{{"aerial", {0, 0, 0}, 0.01}, {"aerial", {2, 0, 0}, 0.01}, {"aerial", {2, 1, 0}, 0.01}};
    plain.paths["aerial"] = {path};
    Measurement fitted = plain;
    fitted.object = "fitted";
    FittedFeature edge;
    edge.mode = SnapMode::edge;
    edge.position = {0.1, 0, 0};
    edge.axis = {0, 1, 0};
    edge.covariance = Eigen::Matrix3d::Identity() * 1e-6;
    fitted.paths["aerial"][0][0].fitted = edge;
    scene.measurements = {plain, fitted};
    const MeasuredScene measured = measureScene(scene);
    const std::string method = measured.lengths.front().method;
    for (const std::string& shown : {method, fittedMethod(method)}) {
        const auto paths = measurementPaths(scene, measured, shown);
        ASSERT_EQ(paths.size(), 2U) << shown;
        EXPECT_EQ(paths[0].points.front(), Vec(0, 0, 0));
        EXPECT_EQ(paths[1].points.front(), shown == method ? Vec(0, 0, 0) : Vec(0.1, 0, 0)) << "each once";
    }
}

TEST(KindStrokes, BetweenPlanesAsManyPointsAsTheSettingSays) {
    std::vector<Vec> picks = kPlane;
    picks.push_back({2, 2, 0});
    for (const Vec& point : kPlane) picks.push_back(point + Vec(0, 0, 1.5));
    const auto strokes = strokesOf(MeasurementKind::planeToPlane, {{"first_plane_points", 4}}, picks);
    ASSERT_EQ(strokes.size(), 3U);
    EXPECT_NEAR(lengthOf(strokes[0]), 1.5, 1e-12);
    EXPECT_EQ(strokes[1].points.size(), 3U);
    EXPECT_EQ(strokes[2].points.size(), 4U);
}

TEST(KindStrokes, ABoxIsItsEdgesRoundAllPicks) {
    // A rectangle of 4 x 2 m turned by 30 degrees, far from the origin.
    const Vec along(std::sqrt(0.75), 0.5, 0), across(-0.5, std::sqrt(0.75), 0), middle(5e5, 4e6, 10);
    const std::vector<Vec> picks{middle + 2 * along + 0.3 * across, middle - 2 * along - 0.5 * across,
                                 middle + across + Vec(0, 0, 1),    middle - across - Vec(0, 0, 1),
                                 middle + 2 * along - 0.9 * across, middle - 2 * along + 0.9 * across,
                                 middle + 1.9 * along + across,     middle - 1.9 * along - across};
    const auto strokes = strokesOf(MeasurementKind::box, {}, picks);
    ASSERT_EQ(strokes.size(), 6U);
    const auto& top = strokes[0].points;
    ASSERT_EQ(top.size(), 4U);
    const double a = (top[1] - top[0]).norm(), b = (top[2] - top[1]).norm();
    EXPECT_NEAR(std::max(a, b), 4, 1e-6);
    EXPECT_NEAR(std::min(a, b), 2, 1e-6);
    for (const Vec& corner : top) EXPECT_EQ(corner.z(), 11);
    EXPECT_NEAR(lengthOf(strokes[2]), 2, 1e-12) << "an upright";
}

TEST(KindStrokes, CrushIsTheDamageTheBaseLineAndTheOutline) {
    std::vector<Vec> picks;
    for (int i = 0; i < 8; ++i) picks.emplace_back(i, i % 3, 0);
    const auto straight = strokesOf(MeasurementKind::crush, {}, picks);
    ASSERT_EQ(straight.size(), 2U);
    EXPECT_EQ(straight[0].points.size(), 6U);
    EXPECT_EQ(straight[1].points, (std::vector<Vec>{picks[0], picks[1]}));
    const auto traced = strokesOf(MeasurementKind::crush, {{"outline_points", 3}}, picks);
    ASSERT_EQ(traced.size(), 3U);
    EXPECT_EQ(traced[0].points.size(), 3U);
    EXPECT_EQ(traced[2].points.front(), picks[5]);
}

TEST(KindStrokes, WhatIsNotDeterminedIsTheLineThroughThePicks) {
    const std::vector<Vec> onOneLine{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    for (const auto kind : {MeasurementKind::pointToPlane, MeasurementKind::box, MeasurementKind::polyline}) {
        const auto strokes = strokesOf(kind, {}, onOneLine);
        ASSERT_EQ(strokes.size(), 1U);
        EXPECT_EQ(strokes[0].points, onOneLine);
        EXPECT_FALSE(strokes[0].closed);
    }
    EXPECT_TRUE(strokesOf(MeasurementKind::area, {}, onOneLine)[0].closed);
    EXPECT_EQ(strokesOf(MeasurementKind::crush, {{"outline_points", 9}}, onOneLine).size(), 1U);
}

}  // namespace
}  // namespace vestige
