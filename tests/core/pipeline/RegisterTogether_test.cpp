#include "core/pipeline/RegisterTogether.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include "core/base/AtomicFile.h"
#include "core/base/Parallel.h"
#include "core/pipeline/Reconstruct.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/pipeline/joint/ExpectedOverlap.h"
#include "tests/core/pipeline/CarScans.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

using test::CarScans;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class RegisterTogether : public testing::Test {
  protected:
    test::TemporaryFolder folder;
};
using ExpectedOverlap = RegisterTogether;

const RegistrationResult& of(const RegisteredLayers& registered, const std::string& id) {
    for (const auto& [layer, result] : registered.layers)
        if (layer == id) return result;
    throw std::runtime_error("not registered: " + id);
}

/// The scene pose of `id` by the pairs alone along the way of layers, the target first.
Similarity alongPairs(const RegisteredLayers& registered, const std::vector<std::string>& way) {
    Similarity place;
    for (std::size_t i = 1; i < way.size(); ++i)
        for (const AdjustedPair& pair : registered.adjustment->pairs) {
            if (!pair.found) continue;
            if (pair.to == way[i - 1] && pair.from == way[i])
                place = {place.pose * pair.found->pose, pair.found->scale};
            if (pair.from == way[i - 1] && pair.to == way[i])
                place = {place.pose * pair.found->pose.inverse(), pair.found->scale};
        }
    return place;
}

TEST_F(RegisterTogether, OfOneScanIsTheRegistrationOfThatScan) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01);
    car.addScan("front", 0);
    const auto alone = registerLayer(car.scene, "front", {});
    ASSERT_TRUE(alone) << alone.error().sentence();
    const auto together = registerLayers(car.scene, {"front"}, {});
    ASSERT_TRUE(together) << together.error().sentence();
    EXPECT_FALSE(together->adjustment);
    const RegistrationResult& result = of(*together, "front");
    EXPECT_EQ(result.targetFromSource.pose.matrix(), alone->targetFromSource.pose.matrix());
    EXPECT_EQ(result.rmse_m, alone->rmse_m);
    EXPECT_EQ(result.notes, alone->notes);
    EXPECT_TRUE(result.via.empty());

    car.scene.layer("front")->init = InitPose{{Pose::Identity(), 0.001}};
    const auto failedAlone = registerLayer(car.scene, "front", {});
    const auto failed = registerLayers(car.scene, {"front"}, {});
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().code, ErrorCode::untrustworthy);
    EXPECT_EQ(failed.error().sentence(), failedAlone.error().sentence());
}

TEST_F(RegisterTogether, AdjustsARingOfScansToBelowTheErrorOfTheChain) {
    double adjusted = 0;
    double chained = 0;
    for (const std::uint64_t seed : {100, 200}) {
        CarScans car(folder.path(), seed);
        car.addAerial("aerial", 0.01);
        car.addScan("front", 0);
        car.addScan("left", 90, "front");
        car.addScan("rear", 180, "left");
        car.addScan("right", 270, "rear");
        const auto registered = registerLayers(car.scene, {"front", "left", "rear", "right"}, {});
        ASSERT_TRUE(registered) << registered.error().sentence();
        ASSERT_TRUE(registered->adjustment);
        EXPECT_FALSE(registered->adjustment->loops.empty());
        EXPECT_GE(registered->adjustment->degreesOfFreedom, 6);
        // Scan against scan: where the first one lies is the aerial cloud's business.
        const auto base = [&](const Similarity& front) {
            return car.truth("front").pose * front.pose.inverse();
        };
        std::vector<std::string> way{"aerial", "front"};
        const Pose adjustedBase = base(of(*registered, "front").targetFromSource);
        const Pose chainedBase = base(alongPairs(*registered, way));
        for (const char* id : {"left", "rear", "right"}) {
            way.push_back(id);
            const Similarity& found = of(*registered, id).targetFromSource;
            const Similarity chain = alongPairs(*registered, way);
            adjusted += std::pow(car.error(id, {adjustedBase * found.pose, found.scale}), 2);
            chained += std::pow(car.error(id, {chainedBase * chain.pose, chain.scale}), 2);
            EXPECT_LT(car.error(id, found), 0.01) << id;
        }
    }
    EXPECT_LT(std::sqrt(adjusted / 6), 0.0005);
    EXPECT_LT(adjusted, 0.8 * chained);
    RecordProperty("adjusted_mm", std::to_string(1000 * std::sqrt(adjusted / 6)));
    RecordProperty("chained_mm", std::to_string(1000 * std::sqrt(chained / 6)));
}

TEST_F(RegisterTogether, ReachesTheSceneThroughAnotherScan) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01, 0.5);
    car.addScan("front", 0);
    car.addScan("left", 90);
    car.addScan("rear", 180, "left");
    const auto registered = registerLayers(car.scene, {"front", "left", "rear"}, {});
    ASSERT_TRUE(registered) << registered.error().sentence();
    EXPECT_LT(car.error("rear", of(*registered, "rear").targetFromSource), 0.03);
    EXPECT_THAT(of(*registered, "rear").via, ElementsAre("left"));
    ASSERT_TRUE(registered->adjustment);
    EXPECT_EQ(registered->adjustment->layers.size(), 3u);
}

TEST_F(RegisterTogether, TakesAFailedPairForNoErrorWhereOthersReachTheLayer) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01, 0.5);
    car.addScan("front", 0);
    car.addScan("left", 90);
    car.addScan("rear", 180);  // its first pose is in the target, which does not show it
    const auto registered = registerLayers(car.scene, {"rear", "front", "left"}, {});
    ASSERT_TRUE(registered) << registered.error().sentence();
    EXPECT_LT(car.error("rear", of(*registered, "rear").targetFromSource), 0.03);
    EXPECT_THAT(of(*registered, "rear").via, Contains("left"));
    EXPECT_THAT(of(*registered, "rear").via, testing::Not(Contains("aerial")));
}

TEST_F(RegisterTogether, NamesTheLayerThatNothingReaches) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01, 0.5);
    car.addScan("front", 0);
    car.addScan("rear", 180);
    const auto registered = registerLayers(car.scene, {"front", "rear"}, {});
    ASSERT_FALSE(registered);
    EXPECT_EQ(registered.error().code, ErrorCode::untrustworthy);
    EXPECT_THAT(registered.error().sentence(), HasSubstr("layer rear"));
}

TEST_F(RegisterTogether, AttemptsGoOnWhereALayerFailsAndTellStepsInTheScene) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01, 0.5);
    car.addScan("front", 0);
    car.addScan("left", 90, "front");
    car.addScan("rear", 180);
    car.scene.layer("rear")->init = InitPicks{folder / "absent.csv"};
    std::vector<Similarity> steps;
    const auto attempted =
        attemptLayers(car.scene, {"front", "left", "rear"}, {}, [&](const std::string& id) {
            return id != "left" ? RegistrationWatch() : [&](const RegistrationStep& step) {
                steps.push_back(step.targetFromSource);
            };
        });
    ASSERT_TRUE(attempted) << attempted.error().sentence();
    ASSERT_EQ(attempted->layers.size(), 3u);
    EXPECT_TRUE(attempted->layers[0].result && attempted->layers[0].result->trustworthy());
    EXPECT_TRUE(attempted->layers[1].result && attempted->layers[1].result->trustworthy());
    EXPECT_FALSE(attempted->layers[2].result);
    ASSERT_TRUE(attempted->layers[2].failure);
    EXPECT_THAT(attempted->layers[2].failure->sentence(), HasSubstr("absent.csv"));
    ASSERT_FALSE(steps.empty());
    for (const Similarity& step : steps) EXPECT_LT(car.error("left", step), 0.3);
    EXPECT_EQ(registerLayers(car.scene, {"front", "rear"}, {}).error().code, ErrorCode::input);
}

TEST_F(RegisterTogether, RefusesFirstPosesThatLeadInACircle) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01);
    car.addScan("front", 0);
    car.addScan("left", 90, "front");
    std::get<InitPicks>(car.scene.layer("front")->init).to = "left";
    const auto registered = registerLayers(car.scene, {"front", "left"}, {});
    ASSERT_FALSE(registered);
    EXPECT_EQ(registered.error().code, ErrorCode::input);
    EXPECT_THAT(registered.error().sentence(), HasSubstr("circle"));
}

TEST_F(RegisterTogether, TakesOutTheOffsetBetweenTwoStrips) {
    CarScans car(folder.path());
    car.addAerial("strip-1", 0.01, -2);
    car.addAerial("strip-2", 0.01, -100, Pose(Eigen::Translation3d(0.05, -0.03, 0.02)));
    EXPECT_FALSE(needsRegistration(car.scene, car.scene.layers[1]));
    ASSERT_TRUE(car.scene.registration.set("strips", true));
    EXPECT_TRUE(needsRegistration(car.scene, car.scene.layers[1]));
    EXPECT_FALSE(needsRegistration(car.scene, car.scene.layers[0]));
    const auto registered = registerLayers(car.scene, {"strip-2"}, {});
    ASSERT_TRUE(registered) << registered.error().sentence();
    EXPECT_LT(car.error("strip-2", of(*registered, "strip-2").targetFromSource), 0.006);
}

TEST_F(RegisterTogether, GivesTheSameBitsForAnyNumberOfThreads) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01);
    car.addScan("front", 0);
    car.addScan("left", 90);
    std::vector<Eigen::Matrix4d> poses;
    for (const int threads : {1, 3}) {
        setThreadCount(threads);
        const auto registered = registerLayers(car.scene, {"front", "left"}, {});
        ASSERT_TRUE(registered) << registered.error().sentence();
        ASSERT_TRUE(registered->adjustment);
        EXPECT_EQ(registered->adjustment->loops.size(), 1u);
        for (const auto& [id, result] : registered->layers)
            poses.push_back(result.targetFromSource.pose.matrix());
    }
    setThreadCount(0);
    EXPECT_EQ(poses[0], poses[2]);
    EXPECT_EQ(poses[1], poses[3]);
}

TEST_F(RegisterTogether, IsToldByReconstruct) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01);
    car.addScan("front", 0);
    car.addScan("left", 90, "front");
    const auto result = reconstruct(car.scene, folder / "out", nullptr, nullptr, {});
    ASSERT_TRUE(result) << result.error().sentence();
    const auto adjustment = nlohmann::json::parse(readTextFile(folder / "out/adjustment.json").value());
    EXPECT_EQ(adjustment["pairs"].size(), 3u);
    ASSERT_EQ(adjustment["loops"].size(), 1u);
    EXPECT_EQ(adjustment["loops"][0]["layers"].size(), 3u);
    EXPECT_LT(adjustment["loops"][0]["translation_m"], 0.1);
    EXPECT_EQ(adjustment["degrees_of_freedom"], 6);
    const auto registrations = nlohmann::json::parse(readTextFile(folder / "out/registration.json").value());
    ASSERT_EQ(registrations.size(), 2u);
    EXPECT_EQ(registrations[1]["via"], nlohmann::json({"front", "aerial"}));
    EXPECT_THAT(readTextFile(folder / "out/manifest.json").value(), HasSubstr("adjustment.json"));

    // Without the second scan there is nothing to adjust, and what a run before left is cleared away.
    car.scene.layers.pop_back();
    ASSERT_TRUE(reconstruct(car.scene, folder / "out", nullptr, nullptr, {}));
    EXPECT_FALSE(std::filesystem::exists(folder / "out/adjustment.json"));
}

TEST_F(RegisterTogether, EndsWhenItIsCancelled) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01);
    car.addScan("front", 0);
    const JobControl control;
    control.cancel();
    const auto registered = registerLayers(car.scene, {"front"}, control);
    ASSERT_FALSE(registered);
    EXPECT_EQ(registered.error().code, ErrorCode::cancelled);
}

TEST_F(ExpectedOverlap, IsTheShareOfTheSmallerCloudThatTheOtherHasToo) {
    CarScans car(folder.path());
    car.addAerial("aerial", 0.01);
    car.addScan("front", 0);
    car.addScan("left", 90);
    car.addScan("rear", 180);
    const auto share = [&](const char* a, const char* b) {
        return expectedOverlap(*car.scene.layer(a)->data->points, car.truth(a),
                               *car.scene.layer(b)->data->points, car.truth(b));
    };
    EXPECT_GT(share("aerial", "front"), 0.8);
    EXPECT_GT(share("front", "left"), 0.35);
    EXPECT_LT(share("front", "left"), 0.75);
    EXPECT_LT(share("front", "rear"), 0.2);
    EXPECT_NEAR(share("left", "front"), share("front", "left"), 0.05);
}

}  // namespace
}  // namespace vestige
