#include "core/scene/picks/PickExchange.h"
#include "core/geometry/PointCloudBuilder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/PickFrame.h"
#include "core/scene/picks/PickLabel.h"
#include "tests/core/scene/SampleScene.h"

namespace vestige {
namespace {

std::vector<ListedPoint> listed(const std::string& csv) {
    const auto points = parsePointList(csv, "picks.csv");
    EXPECT_TRUE(points) << (points ? "" : points.error().sentence());
    return points.value_or(std::vector<ListedPoint>());
}

ImportedPicks imported(const SceneState& scene, const std::string& csv, const PicksTarget& target = {}) {
    const auto picks = importPicks(scene, listed(csv), target, "picks.csv");
    EXPECT_TRUE(picks) << (picks ? "" : picks.error().sentence());
    return picks.value_or(ImportedPicks());
}

std::string refusalOf(const SceneState& scene, const std::string& csv, const PicksTarget& target = {}) {
    const auto picks = importPicks(scene, listed(csv), target, "picks.csv");
    return picks ? std::string() : picks.error().sentence();
}

SceneState sceneWithPath() {
    SceneState scene = test::sampleScene();
    Measurement skid;
    skid.object = "Skid | left";
    skid.kind = MeasurementKind::polyline;
    for (int i = 0; i < 12; ++i) skid.paths["aerial"].resize(1);
    for (int i = 0; i < 12; ++i)
        skid.paths["aerial"][0].push_back(pickAt(scene, "aerial", {1.0 * i, 0.1 * i * i, 0}));
    scene.measurements.push_back(skid);
    return scene;
}

TEST(PickLabels, ReadBackWhatTheySay) {
    for (const PickLabel& label : {PickLabel{"Length", "aerial", 1, false, 0, "aerial"},
                                   {"Length", "lidar", 12, false, 1, "front"},
                                   {"A | B", "aerial", 3, true, 41, "aerial"},
                                   {"3", "1", 2, true, 0, "4"},
                                   {"3", "1", 2, true, 0, "a"},
                                   {"3", "1", 2, false, 0, "p1"}}) {
        const auto read = parsePickLabel(textOf(label));
        ASSERT_TRUE(read) << textOf(label);
        EXPECT_EQ(read->object, label.object) << textOf(label);
        EXPECT_EQ(read->key, label.key);
        EXPECT_EQ(read->repeat, label.repeat);
        EXPECT_EQ(read->end, label.end);
        EXPECT_EQ(read->ofPath, label.ofPath);
        EXPECT_EQ(read->layer, label.layer);
    }
    for (const char* text : {"", "Point 1", "a | b", "a | b | c | d", "a | b | 0 | a", "a | b | 1 | 2",
                             "a | b | 1 | p0", " | b | 1 | a"})
        EXPECT_FALSE(parsePickLabel(text)) << text;
}

TEST(PickExchange, WhatIsWrittenReadsBack) {
    const SceneState scene = sceneWithPath();
    const std::string csv = picksCsv(scene);
    SceneState emptied = scene;
    for (Measurement& measurement : emptied.measurements) {
        measurement.picks.clear();
        measurement.paths.clear();
    }
    for (Measurement& changed : imported(emptied, csv).changed)
        *emptied.measurement(changed.object) = changed;
    EXPECT_EQ(picksCsv(emptied).size(), csv.size());
    for (const Measurement& before : scene.measurements) {
        const Measurement& after = *emptied.measurement(before.object);
        EXPECT_EQ(after.kind, before.kind);
        for (const auto& [key, pairs] : before.picks) {
            if (pairs.empty()) continue;
            ASSERT_TRUE(after.picks.contains(key)) << before.object << " " << key;
            ASSERT_EQ(after.picks.at(key).size(), pairs.size());
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                const PickedPair& now = after.picks.at(key)[i];
                EXPECT_EQ(now.a.layer, pairs[i].a.layer);
                EXPECT_LT((scenePosition(emptied, now.a) - scenePosition(scene, pairs[i].a)).norm(), 1e-9);
                EXPECT_LT((scenePosition(emptied, now.b) - scenePosition(scene, pairs[i].b)).norm(), 1e-9);
            }
        }
        ASSERT_EQ(after.paths.size(), before.paths.size());
    }
    EXPECT_EQ(emptied.measurement("Skid | left")->paths.at("aerial")[0].size(), 12u);
}

TEST(PickExchange, NothingIsTakenTwice) {
    const SceneState scene = sceneWithPath();
    const ImportedPicks again = imported(scene, picksCsv(scene));
    EXPECT_EQ(again.repeats, 0u);
    EXPECT_EQ(again.known, 5u);
    for (const Measurement& measurement : again.changed)
        EXPECT_EQ(measurement.picks, scene.measurement(measurement.object)->picks) << measurement.object;
}

TEST(PickExchange, RepeatsOnTheSamePlaceAllCount) {
    SceneState scene = test::sampleScene();
    Measurement twice;
    twice.object = "Twice";
    const PickedPair pair{pickAt(scene, "aerial", {0, 0, 0}), pickAt(scene, "aerial", {1, 0, 0})};
    twice.picks["aerial"] = {pair, pair};
    scene.measurements = {twice};
    const std::string csv = picksCsv(scene);
    EXPECT_EQ(imported(scene, csv).known, 2u);
    scene.measurements[0].picks["aerial"].pop_back();
    EXPECT_EQ(imported(scene, csv).repeats, 1u);
    scene.measurements.clear();
    EXPECT_EQ(imported(scene, csv).changed[0].picks.at("aerial").size(), 2u);
}

TEST(PickExchange, PlainPointsArePairsOfTheTarget) {
    const SceneState scene = test::sampleScene();
    const ImportedPicks picks =
        imported(scene, "0,1,2,3\n1,4,2,3\n2,1,2,3.5\n3,4,2,3.5\n", {"Bonnet", "aerial"});
    ASSERT_EQ(picks.changed.size(), 1u);
    EXPECT_EQ(picks.repeats, 2u);
    const auto& pairs = picks.changed[0].picks.at("aerial");
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[1].a.position, Eigen::Vector3d(1, 2, 3.5));
    EXPECT_EQ(pairs[1].b.position, Eigen::Vector3d(4, 2, 3.5));
    const ImportedPicks more = imported(scene, "0,0,9\n5,0,9\n", {"Length of the vehicle", "aerial"});
    EXPECT_EQ(more.changed[0].picks.at("aerial").size(), 3u) << "behind those that are there";
    EXPECT_EQ(more.changed[0].tape_m, 4.93);
}

TEST(PickExchange, PointsInShiftedCoordinatesAreRefused) {
    SceneState scene = test::sampleScene();
    PointCloudBuilder builder;
    for (int i = 0; i < 10; ++i) builder.add(Eigen::Vector3d(483000.0 + i, 4375000, 30));
    auto data = std::make_shared<LayerData>();
    data->points = std::make_shared<const PointCloud>(std::move(builder).build());
    scene.layers[0].data = data;
    const PicksTarget target{"A", scene.layers[0].id};
    EXPECT_EQ(refusalOf(scene, "483000,4375000,30\n483009,4375000,30\n", target), "");
    EXPECT_NE(refusalOf(scene, "483000,4375000,30\n9,0,0\n", target)
                  .find("picks.csv line 2: the point lies far away"),
              std::string::npos);
}

TEST(PickExchange, WhatDoesNotFitIsSaidWithItsLine) {
    const SceneState scene = test::sampleScene();
    EXPECT_NE(refusalOf(scene, "1,2,3\n4,5,6\n7,8,9\n", {"A", "aerial"})
                  .find("picks.csv line 3: the last of 3 points has no partner"),
              std::string::npos);
    EXPECT_NE(refusalOf(scene, "1,2,3\n4,5,6\n", {"A", "nowhere"}).find("no layer 'nowhere'"),
              std::string::npos);
    EXPECT_NE(
        refusalOf(scene, "A | rear | 1 | a,1,2,3\n").find("picks.csv line 1: the case has no layer 'rear'"),
        std::string::npos);
    EXPECT_NE(refusalOf(scene, "A | aerial | 1 | a,1,2,3\n").find("lacks an end"), std::string::npos);
    EXPECT_NE(refusalOf(scene, "A | aerial | 1 | p1,1,2,3\nA | aerial | 1 | p3,1,2,3\n").find("lacks an end"),
              std::string::npos);
    EXPECT_NE(refusalOf(scene, "A | aerial | 1 | a,1,2,3\nA | aerial | 1 | a,1,2,3\n").find("stands twice"),
              std::string::npos);
    EXPECT_NE(refusalOf(scene, "A | aerial | 1 | a,1,2,3\nPoint 7,1,2,3\n")
                  .find("picks.csv line 2: the label is 'Point 7'"),
              std::string::npos);
}

}  // namespace
}  // namespace vestige
