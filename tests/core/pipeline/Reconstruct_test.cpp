#include "core/pipeline/Reconstruct.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include "core/base/AtomicFile.h"
#include "core/base/Csv.h"
#include "core/base/Hash.h"
#include "core/base/Parallel.h"
#include "core/io/FormatRegistry.h"
#include "core/pipeline/LoadLayers.h"
#include "tests/core/pipeline/TinyCase.h"
#include "tests/core/report/ReportText.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::NotingPrinter;
using test::NotingRenderer;
using test::TemporaryFolder;
using test::TinyCase;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;

constexpr const char* kStable[] = {"fused.las", "registration.json", "measurements.csv", "accuracy.csv"};

std::string content(const fs::path& file) {
    return readTextFile(file).value();
}

std::vector<std::string> paths(const Reconstruction& result) {
    std::vector<std::string> names;
    for (const auto& output : result.outputs) names.push_back(output.path);
    return names;
}

class Reconstructing : public testing::Test {
  protected:
    Result<Reconstruction> run(const SceneState& scene, const fs::path& out, const JobControl& control = {}) {
        return reconstruct(scene, out, &renderer, &printer, control);
    }

    TemporaryFolder folder;
    NotingRenderer renderer;
    NotingPrinter printer;
};

TEST_F(Reconstructing, LeavesEverythingThatTheContractLists) {
    const TinyCase tiny(folder.path());
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_THAT(paths(*result),
                IsSupersetOf({"fused.las", "registration.json", "measurements.csv", "accuracy.csv",
                              "report.pdf", "manifest.json", "screenshots/overview-perspective.png",
                              "screenshots/overview-top.png", "screenshots/registration-front-before.png",
                              "screenshots/registration-front-after.png"}));
    EXPECT_TRUE(result->notMade.empty());
    for (const auto& output : result->outputs)
        EXPECT_EQ(sha256OfFile(folder / "out" / output.path).value(), output.sha256) << output.path;

    const auto manifest = json::parse(content(folder / "out/manifest.json"));
    const std::string text = manifest.dump();
    for (const char* input : {"aerial.ply", "front.ply", "front_picks.csv"})
        EXPECT_THAT(text, HasSubstr(sha256OfFile(folder / input).value())) << input;
    EXPECT_EQ(manifest["outputs"].size(), result->outputs.size() - 1) << "all but the manifest itself";
    EXPECT_GE(printer.printed.sections.size(), 8u);
}

TEST_F(Reconstructing, RegistersAndMeasures) {
    const TinyCase tiny(folder.path());
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();

    const auto registrations = json::parse(content(folder / "out/registration.json"));
    ASSERT_EQ(registrations.size(), 1u);
    EXPECT_EQ(registrations[0]["layer"], "front");
    EXPECT_EQ(registrations[0]["scale"], 0.001);
    EXPECT_FALSE(registrations[0].contains("seconds"));
    const Eigen::Vector3d corner = tiny.truth.inverse() * (TinyCase::origin() + Eigen::Vector3d(1.8, 0, 1.4));
    const Similarity& found = result->scene.layer("front")->registration->targetFromSource;
    EXPECT_LT((found * corner - tiny.truth * corner).norm(), 0.02);

    const auto rows = readCsv(folder / "out/measurements.csv").value();
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[1].cells[0], "Length of the box");
    EXPECT_NEAR(std::stod(rows[1].cells[6]), 4.3967, 1e-3);
    EXPECT_EQ(rows[2].cells[0], "Width of the front");
    EXPECT_NEAR(std::stod(rows[2].cells[6]), 1.0, 0.03)
        << "aims hit points of a cloud with 20 mm between them";
}

TEST_F(Reconstructing, ReadsWhatIsWholeOfADamagedFileOnlyWhereTheCaseAgrees) {
    TinyCase tiny(folder.path());
    const fs::path aerial = folder / "aerial.ply";
    fs::resize_file(aerial, fs::file_size(aerial) - 5);
    const auto refused = run(tiny.scene, folder / "out");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::input);
    EXPECT_TRUE(refused.error().salvageable);
    tiny.scene.layers[0].salvage = true;
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();
    const std::string& damage = result->scene.layer("aerial")->data->info.damage;
    EXPECT_THAT(damage, HasSubstr("are whole and were read"));
    EXPECT_THAT(result->warnings, testing::Contains("aerial.ply: " + damage));
    EXPECT_THAT(json::parse(content(folder / "out/manifest.json"))["warnings"].dump(),
                HasSubstr("the file is damaged"));
    EXPECT_THAT(test::textOf(printer.printed), HasSubstr("Only part of aerial.ply could be read"));
}

TEST_F(Reconstructing, NoResultReplacesWhatItWasComputedFrom) {
    TinyCase tiny(folder.path());
    fs::create_directories(folder / "out");
    fs::rename(folder / "front.ply", folder / "out/fused.las.ply");
    for (Layer& layer : tiny.scene.layers)
        if (layer.path.filename() == "front.ply") layer.path = folder / "out/fused.las.ply";
    ASSERT_TRUE(run(tiny.scene, folder / "out")) << "beside it is enough";
    fs::create_hard_link(folder / "out/fused.las.ply", folder / "evidence.ply");
    fs::remove(folder / "out/fused.las");
    fs::create_symlink("../evidence.ply", folder / "out/fused.las");
    const std::string before = content(folder / "evidence.ply");
    const auto refused = run(tiny.scene, folder / "out");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("a result would replace layer front, an input"));
    EXPECT_EQ(content(folder / "evidence.ply"), before);
    EXPECT_TRUE(fs::is_symlink(folder / "out/fused.las"));
}

TEST_F(Reconstructing, MarksEvidenceThatChanged) {
    TinyCase tiny(folder.path());
    const std::string expected(64, 'a');
    tiny.scene.layers[0].evidence = FileEvidence{expected, 1, {}};
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();
    const auto manifest = json::parse(content(folder / "out/manifest.json"));
    int marked = 0;
    for (const auto& input : manifest["inputs"]) {
        marked += input.contains("expected_sha256");
        if (input["path"] == tiny.scene.layers[0].path.string()) {
            EXPECT_EQ(input["expected_sha256"], expected);
        }
    }
    EXPECT_EQ(marked, 1);
    const std::string report = test::textOf(printer.printed);
    EXPECT_THAT(report, HasSubstr("Changed since it became part of the case: aerial.ply"));
    EXPECT_THAT(report, HasSubstr("A file changed: layer 'aerial'"));
}

TEST_F(Reconstructing, FusesTheOriginalPointsLayerByLayer) {
    const TinyCase tiny(folder.path());
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();
    const auto fused = readGeometry(folder / "out/fused.las");
    ASSERT_TRUE(fused) << fused.error().sentence();
    const PointCloud& cloud = fused->geometry.vertices;
    const PointCloud& aerial = *result->scene.layer("aerial")->data->points;
    const PointCloud& front = *result->scene.layer("front")->data->points;
    ASSERT_EQ(cloud.size(), aerial.size() + front.size());
    EXPECT_LT((cloud.point(5) - aerial.point(5)).norm(), 2e-4);
    const Similarity place = sceneFromLayer(*result->scene.layer("front"));
    EXPECT_LT((cloud.point(aerial.size() + 9) - place * front.point(9)).norm(), 2e-4);
    const auto& source = cloud.attributes().pointSource;
    ASSERT_EQ(source.size(), cloud.size());
    EXPECT_EQ(source.front(), 1);
    EXPECT_EQ(source[aerial.size() - 1], 1);
    EXPECT_EQ(source[aerial.size()], 2);
    EXPECT_EQ(source.back(), 2);
    EXPECT_THAT(content(folder / "out/fused.las"), HasSubstr("2\tfront\tfront\n"));
}

TEST_F(Reconstructing, FusesAttributesThatStayedInTheFiles) {
    TinyCase tiny(folder.path());
    Layer& aerial = *tiny.scene.layer("aerial");
    const auto plain = readGeometry(aerial.path);
    ASSERT_TRUE(plain);
    PointAttributes attributes = plain->geometry.vertices.attributes();
    for (std::size_t i = 0; i < plain->geometry.vertices.size(); ++i) {
        attributes.classification.push_back(static_cast<std::uint8_t>(i % 7));
        attributes.gpsTime.push_back(1000 + 0.5 * static_cast<double>(i));
        attributes.returnNumber.push_back(1);
        attributes.returnCount.push_back(2);
    }
    const PointCloud full = plain->geometry.vertices.withAttributes(attributes);
    aerial.path = folder / "aerial.las";
    ASSERT_TRUE(writeGeometry(aerial.path, {full, {}}));
    const auto asked = run(tiny.scene, folder / "asked");
    ASSERT_TRUE(asked) << asked.error().sentence();
    EXPECT_TRUE(asked->scene.layer("aerial")->data->points->attributes().gpsTime.empty());
    for (Layer& layer : tiny.scene.layers) {
        auto data = loadLayerData(layer.path, {}, {});
        ASSERT_TRUE(data);
        layer.data = *data;
    }
    ASSERT_TRUE(run(tiny.scene, folder / "held"));
    EXPECT_EQ(content(folder / "asked/fused.las"), content(folder / "held/fused.las"));
    const auto fused = readGeometry(folder / "asked/fused.las");
    ASSERT_TRUE(fused);
    EXPECT_EQ(fused->geometry.vertices.attributes().classification[6], 6);
    EXPECT_EQ(fused->geometry.vertices.attributes().gpsTime[5], 1002.5);
}

TEST_F(Reconstructing, ReadsThePartThatTheCaseNamesAndReportsIt) {
    TinyCase tiny(folder.path());
    const auto whole = readGeometry(tiny.scene.layer("aerial")->path);
    ASSERT_TRUE(whole);
    tiny.scene.layer("aerial")->keepEvery = 2;
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();
    const PointCloud& thinned = *result->scene.layer("aerial")->data->points;
    ASSERT_EQ(thinned.size(), (whole->geometry.vertices.size() + 1) / 2);
    EXPECT_EQ(thinned.point(3), whole->geometry.vertices.point(6));
    EXPECT_THAT(test::textOf(printer.printed), HasSubstr("aerial: one of every 2 points"));
}

TEST_F(Reconstructing, IsTheSameOnEveryRunAndForAnyNumberOfThreads) {
    const TinyCase tiny(folder.path());
    setThreadCount(2);
    const auto first = run(tiny.scene, folder / "first");
    ASSERT_TRUE(first) << first.error().sentence();
    for (const int threads : {1, 2, 7}) {
        setThreadCount(threads);
        const fs::path out = folder / ("again-" + std::to_string(threads));
        ASSERT_TRUE(run(tiny.scene, out));
        for (const auto& name : paths(*first)) {
            if (name == "manifest.json") continue;
            EXPECT_EQ(content(folder / "first" / name), content(out / name))
                << name << ", threads " << threads;
        }
    }
    setThreadCount(0);
}

TEST_F(Reconstructing, ReportsWhatIsNotMeasurableWithoutTheHandheldScan) {
    const TinyCase tiny(folder.path(), false);
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_EQ(content(folder / "out/registration.json"), "[]\n");
    const auto rows = readCsv(folder / "out/measurements.csv").value();
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_FALSE(rows[1].cells[6].empty());
    for (std::size_t column = 3; column < 10; ++column) EXPECT_EQ(rows[2].cells[column], "");
    EXPECT_EQ(rows[2].cells[10], "false");
}

TEST_F(Reconstructing, ListsWhatNeedsARendererOrPrinterThatIsNotThere) {
    const TinyCase tiny(folder.path(), false);
    const auto result = reconstruct(tiny.scene, folder / "out", nullptr, nullptr, {});
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_THAT(result->notMade, IsSupersetOf({"report.pdf", "screenshots/overview-top.png"}));
    EXPECT_FALSE(fs::exists(folder / "out/report.pdf"));
    for (const char* name : kStable) EXPECT_TRUE(fs::exists(folder / "out" / name)) << name;
}

TEST_F(Reconstructing, FailsOnABrokenInputAndLeavesEarlierResultsUntouched) {
    const TinyCase tiny(folder.path());
    ASSERT_TRUE(writeTextFile(folder / "out/measurements.csv", "earlier"));
    ASSERT_TRUE(writeTextFile(folder / "front.ply", "ply\nformat ascii 1.0\nelement vertex 5\n"));
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::input);
    EXPECT_THAT(result.error().sentence(), HasSubstr("front.ply"));
    EXPECT_EQ(content(folder / "out/measurements.csv"), "earlier");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out"), {}), 1);
}

TEST_F(Reconstructing, FailsWhereAScanFindsNoCounterpart) {
    TinyCase tiny(folder.path());
    Similarity away = tiny.truth;
    away.pose.translation() += Eigen::Vector3d(300, 0, 0);
    tiny.scene.layer("front")->init = InitPose{away};
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::untrustworthy);
    EXPECT_THAT(result.error().sentence(), HasSubstr("front"));
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(Reconstructing, FindsAnAutomaticFirstPose) {
    TinyCase tiny(folder.path());
    tiny.scene.layer("front")->init = InitAuto{};
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_TRUE(result) << result.error().sentence();
    EXPECT_THAT(content(folder / "out/registration.json"), HasSubstr("first pose found"));
}

TEST_F(Reconstructing, StopsWhenCancelledAndLeavesNothing) {
    const TinyCase tiny(folder.path());
    JobControl control(
        [&control](double fraction, std::string_view) {
            if (fraction > 0.3) control.cancel();
        },
        {});
    const auto result = run(tiny.scene, folder / "out", control);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
    for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("out")));
}

TEST_F(Reconstructing, RefusesAnOutputFolderThatIsAFileBeforeItBegins) {
    const TinyCase tiny(folder.path(), false);
    ASSERT_TRUE(writeTextFile(folder / "out", "a file"));
    const auto result = run(tiny.scene, folder / "out");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::output);
    EXPECT_EQ(content(folder / "out"), "a file");
}

TEST_F(Reconstructing, RemovesPicturesOfAnEarlierRunThatItDoesNotMakeAgain) {
    const TinyCase tiny(folder.path());
    ASSERT_TRUE(run(tiny.scene, folder / "out"));
    ASSERT_TRUE(writeTextFile(folder / "out/notes.txt", "the analyst's own"));
    const TinyCase without(folder.path(), false);
    ASSERT_TRUE(run(without.scene, folder / "out"));
    EXPECT_FALSE(fs::exists(folder / "out/screenshots/registration-front-after.png"));
    EXPECT_TRUE(fs::exists(folder / "out/screenshots/overview-top.png"));
    EXPECT_TRUE(fs::exists(folder / "out/notes.txt"));
}

}  // namespace
}  // namespace vestige
