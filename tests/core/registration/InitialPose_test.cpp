#include "core/registration/InitialPose.h"

#include <gtest/gtest.h>
#include <fstream>

#include "core/base/AtomicFile.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

Similarity truth() {
    Similarity similarity;
    similarity.scale = 0.001;
    similarity.pose.linear() =
        Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    similarity.pose.translation() << 500123.25, 5400456.5, 81.75;
    return similarity;
}

std::vector<PointPair> pairs(double error_m) {
    Random random(4);
    std::vector<PointPair> made;
    for (int i = 0; i < 5; ++i) {
        const Eigen::Vector3d source(random.uniform(-900, 900), random.uniform(-900, 900),
                                     random.uniform(-900, 900));
        const Eigen::Vector3d error(random.normal(), random.normal(), random.normal());
        made.push_back({truth() * source + error_m * error, source});
    }
    return made;
}

TEST(AlignPairs, FindsThePoseExactlyFromExactPairs) {
    const auto alignment = alignPairs(pairs(0), 0.001);
    ASSERT_TRUE(alignment) << alignment.error().sentence();
    EXPECT_NEAR((alignment->targetFromSource.pose.linear() - truth().pose.linear()).norm(), 0, 1e-7);
    EXPECT_LT(alignment->error_m, 1e-7);
    EXPECT_EQ(alignment->targetFromSource.scale, 0.001);
}

TEST(AlignPairs, GivesTheResidualOfEachPair) {
    const auto alignment = alignPairs(pairs(0.02), 0.001);
    ASSERT_TRUE(alignment);
    ASSERT_EQ(alignment->residuals_m.size(), 5U);
    EXPECT_GT(alignment->error_m, 0.005);
    EXPECT_LT(alignment->error_m, 0.05);
}

TEST(AlignPairs, TellsTheErrorOfThreePairsNotTheirResidual) {
    constexpr double kError_m = 0.02;
    Random random(5);
    double squares = 0;
    constexpr int kTrials = 2000;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<PointPair> three = pairs(0);
        three.resize(3);
        for (PointPair& pair : three) {
            const double x = random.normal(), y = random.normal(), z = random.normal();
            pair.target += kError_m * Eigen::Vector3d(x, y, z);
        }
        const auto alignment = alignPairs(three, 0.001);
        ASSERT_TRUE(alignment);
        squares += alignment->error_m * alignment->error_m;
    }
    EXPECT_NEAR(std::sqrt(squares / kTrials), std::sqrt(3.0) * kError_m, 0.05 * kError_m);
}

TEST(AlignPairs, RefusesPairsThatContradictEachOther) {
    std::vector<PointPair> swapped = pairs(0.01);
    std::swap(swapped[1].target, swapped[3].target);
    const auto alignment = alignPairs(swapped, 0.001);
    ASSERT_FALSE(alignment);
    EXPECT_EQ(alignment.error().code, ErrorCode::untrustworthy);
    EXPECT_NE(alignment.error().message.find("pair "), std::string::npos);
    EXPECT_FALSE(alignPairs(pairs(0.01), 1)) << "millimetres taken for metres";
}

TEST(AlignPairs, RefusesPointsOnALineAndTooFew) {
    std::vector<PointPair> line;
    for (int i = 0; i < 4; ++i) line.push_back({Eigen::Vector3d(i, 2 * i, 3), Eigen::Vector3d(i, 2 * i, 3)});
    const auto onLine = alignPairs(line, 1);
    ASSERT_FALSE(onLine);
    EXPECT_EQ(onLine.error().code, ErrorCode::untrustworthy);
    const auto two = alignPairs(std::span(line).first(2), 1);
    ASSERT_FALSE(two);
    EXPECT_EQ(two.error().code, ErrorCode::input);
}

TEST(PointPairs, ErrorsNameTheLine) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "good.csv",
                              "tx,ty,tz,sx,sy,sz\r\n1,2,3,4,5,6\r\n1,2,4,4,5,7\r\n1.5,2,3,4,5.25,6\r\n"));
    const auto good = readPointPairs(folder / "good.csv");
    ASSERT_TRUE(good) << good.error().sentence();
    EXPECT_EQ(good->at(2).source, Eigen::Vector3d(4, 5.25, 6));
    const auto sentence = [&](const char* text) {
        EXPECT_TRUE(writeTextFile(folder / "bad.csv", text));
        const auto bad = readPointPairs(folder / "bad.csv");
        EXPECT_FALSE(bad);
        return bad ? std::string() : bad.error().sentence();
    };
    EXPECT_NE(sentence("tx,ty,tz,sx,sy,sz\n1,2,3,4,5,6\n1,2,x,4,5,6\n").find("line 3"), std::string::npos);
    EXPECT_NE(sentence("tx,ty,tz,sx,sy,sz\n1,2,3,4,5\n").find("line 2"), std::string::npos);
    EXPECT_NE(sentence("a,b\n1,2\n").find("line 1"), std::string::npos);
    EXPECT_NE(sentence("tx,ty,tz,sx,sy,sz\n1,2,3,4,5,6\n").find("three"), std::string::npos);
    EXPECT_FALSE(readPointPairs(folder / "absent.csv"));
}

TEST(PoseFile, ReadsBackTheSameBits) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writePoseFile(folder / "pose.json", truth()));
    const auto read = readPoseFile(folder / "pose.json");
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->pose.matrix(), truth().pose.matrix());
    EXPECT_EQ(read->scale, 0.001);
}

TEST(PoseFile, ErrorsNameTheField) {
    const test::TemporaryFolder folder;
    const auto sentence = [&](const char* text) {
        EXPECT_TRUE(writeTextFile(folder / "bad.json", text));
        const auto bad = readPoseFile(folder / "bad.json");
        EXPECT_FALSE(bad);
        return bad ? std::string() : bad.error().sentence();
    };
    EXPECT_NE(sentence("{").find("JSON"), std::string::npos);
    EXPECT_NE(sentence("[]").find("'pose'"), std::string::npos);
    EXPECT_NE(sentence(R"({"pose":[1,2]})").find("16"), std::string::npos);
    EXPECT_NE(sentence(R"({"pose":[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]})").find("orthonormal"),
              std::string::npos);
    EXPECT_NE(sentence(R"({"pose":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1],"scale":-1})").find("scale"),
              std::string::npos);
}

TriangleMesh wall(double width, double spacing) {
    PointCloudBuilder builder;
    for (double x = 0; x < width; x += spacing)
        for (double y = 0; y < width; y += spacing) builder.add({x, y, 0});
    return {std::move(builder).build(), {}};
}

TEST(GuessUnit, FromPairsFromSizeAndFromSpacing) {
    const auto fromPairs = guessUnit({}, 1, {}, pairs(0.01));
    EXPECT_EQ(fromPairs.metresPerUnit, metresPer(LengthUnit::millimetre));
    EXPECT_TRUE(fromPairs.certain);
    // A car's front, 2000 units wide, beside a scene of 100 m.
    const auto front = guessUnit(wall(100, 0.5), 1, wall(2000, 10), {});
    EXPECT_EQ(front.metresPerUnit, metresPer(LengthUnit::millimetre));
    EXPECT_NE(front.reason.find("millimetres"), std::string::npos);
    // A mirror, 200 units wide.
    EXPECT_EQ(guessUnit(wall(100, 0.1), 1, wall(200, 1.5), {}).metresPerUnit,
              metresPer(LengthUnit::millimetre));
    // Another flight over the same place, and a part of it.
    EXPECT_EQ(guessUnit(wall(100, 0.5), 1, wall(120, 0.7), {}).metresPerUnit, 1);
    EXPECT_EQ(guessUnit(wall(100, 0.5), 1, wall(3, 0.05), {}).metresPerUnit, 1);
}

/// Of this process, bytes.
long memoryPeak() {
    std::ifstream status("/proc/self/status");
    long kibibytes = 0;
    for (std::string word; status >> word;)
        if (word == "VmHWM:") status >> kibibytes;
    return 1024 * kibibytes;
}

TEST(GuessUnit, LooksAtLargeCloudsWithoutCopyingThem) {
    constexpr long kPoints = 6'000'000;
    PointCloudBuilder builder;
    builder.reserve(kPoints);
    for (long i = 0; i < kPoints; ++i)
        builder.add({static_cast<double>(i % 3000) / 30, static_cast<double>(i / 3000) / 30, 0});
    const TriangleMesh scene{std::move(builder).build(), {}};
    const TriangleMesh scan = wall(2000, 10);
    // The peak counts anew from here.
    std::ofstream("/proc/self/clear_refs") << 5;
    const long before = memoryPeak();
    const UnitGuess guess = guessUnit(scene, 1, scan, {});
    EXPECT_LT(memoryPeak() - before, 12 * kPoints);
    EXPECT_EQ(guess.metresPerUnit, 0.001);
    EXPECT_NE(guess.reason.find("with a point every 0.03"), std::string::npos) << guess.reason;
}

TEST(GuessUnit, ComparesWithATargetOfAnyUnitInMetres) {
    // A part of a scene of 50 m, both in millimetres.
    const UnitGuess front = guessUnit(wall(50000, 250), 0.001, wall(2000, 10), {});
    EXPECT_EQ(front.metresPerUnit, metresPer(LengthUnit::millimetre));
    EXPECT_NE(front.reason.find("the target 70.36 m with a point every 0.2"), std::string::npos)
        << front.reason;
    // Another flight over a place of 100 m that is held in feet.
    EXPECT_EQ(guessUnit(wall(328, 1.6), 0.3048, wall(90, 0.5), {}).metresPerUnit, 1);
    EXPECT_EQ(guessUnit(wall(328, 1.6), 0.3048, wall(1500, 10), {}).metresPerUnit,
              metresPer(LengthUnit::millimetre))
        << "as feet the target would be as large";
}

TEST(GuessUnit, TheFileIsBelievedUnlessPairsSayOtherwise) {
    // A wall of 30 m in feet: its size alone would make it metres.
    const TriangleMesh inFeet = wall(98.4, 1);
    EXPECT_EQ(guessUnit(wall(100, 0.5), 1, inFeet, {}).metresPerUnit, 1);
    const UnitGuess said = guessUnit(wall(100, 0.5), 1, inFeet, {}, metresPer(LengthUnit::usSurveyFoot));
    EXPECT_EQ(said.metresPerUnit, metresPer(LengthUnit::usSurveyFoot));
    EXPECT_TRUE(said.certain);
    EXPECT_NE(said.reason.find("US survey feet"), std::string::npos);
    // Clarke's foot, which is none of ours; and a US survey foot with fewer digits is that foot.
    const UnitGuess clarke = guessUnit(wall(100, 0.5), 1, inFeet, {}, 0.3047972654);
    EXPECT_EQ(clarke.metresPerUnit, 0.3047972654);
    EXPECT_NE(clarke.reason.find("units of 0.3047972654 m"), std::string::npos) << clarke.reason;
    EXPECT_EQ(guessUnit({}, 1, {}, pairs(0.01), 0.914398).metresPerUnit, 0.001) << "yards, pairs in mm";
    EXPECT_EQ(guessUnit({}, 1, inFeet, {}, 0.3048006096).metresPerUnit, metresPer(LengthUnit::usSurveyFoot));
    // Pairs in millimetres, and a file that says so, or says inches, or feet of pairs in feet.
    EXPECT_EQ(guessUnit({}, 1, {}, pairs(0.01), metresPer(LengthUnit::millimetre)).metresPerUnit,
              metresPer(LengthUnit::millimetre));
    const UnitGuess wrong = guessUnit({}, 1, {}, pairs(0.01), metresPer(LengthUnit::inch));
    EXPECT_EQ(wrong.metresPerUnit, metresPer(LengthUnit::millimetre));
    EXPECT_NE(wrong.reason.find("although its file says inches"), std::string::npos);
    std::vector<PointPair> feet = pairs(0.01);
    for (PointPair& pair : feet) pair.source *= 0.001 / 0.3048;
    EXPECT_EQ(guessUnit({}, 1, {}, feet).metresPerUnit, metresPer(LengthUnit::foot));
    EXPECT_EQ(guessUnit({}, 1, {}, feet, metresPer(LengthUnit::usSurveyFoot)).metresPerUnit,
              metresPer(LengthUnit::usSurveyFoot))
        << "pairs cannot tell the two feet apart";
}

}  // namespace
}  // namespace vestige
