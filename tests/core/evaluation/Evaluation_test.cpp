#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/evaluation/EvaluationPlan.h"
#include "core/evaluation/SequenceCsv.h"
#include "core/evaluation/SequenceEvaluation.h"
#include "core/evaluation/SizeComparison.h"
#include "core/filters/Preprocess.h"
#include "core/registration/Register.h"
#include "tests/core/evaluation/EvaluationClouds.h"

namespace vestige {
namespace {

using test::walk;

const ParameterSet kUnfiltered = [] {
    ParameterSet set(preprocessParameters());
    EXPECT_TRUE(set.set("filter", std::string("none")));
    return set;
}();

TEST(SequenceEvaluation, ChainsThePosesOfASequence) {
    Sequence sequence;
    sequence.truth = walk();
    for (std::size_t i = 0; i < sequence.truth.size(); ++i)
        sequence.clouds.push_back(test::room(sequence.truth[i], i + 1));
    const ParameterSet registration = comparedRegistration();
    const auto score = evaluateSequence(sequence, kUnfiltered, registration);
    ASSERT_TRUE(score) << score.error().sentence();
    EXPECT_EQ(score->failed, 0U);
    EXPECT_EQ(score->error.pairs, 3U);
    EXPECT_LT(score->error.translation_m, 0.005);
    EXPECT_GT(score->error.translation_m, 0);
    ASSERT_EQ(score->pairs.size(), 3U);
    EXPECT_NEAR(score->pairs[0].moved.translation_m, std::hypot(0.15, 0.05), 1e-9);
    EXPECT_NEAR(score->pairs[1].moved.rotation_rad, 0.07, 1e-9);
    double squares = 0;
    for (const PairScore& pair : score->pairs) squares += std::pow(pair.error.translation_m, 2);
    EXPECT_NEAR(std::sqrt(squares / 3), score->error.translation_m, 1e-12);
    const auto two = evaluateSequence(sequence, kUnfiltered, registration, 2);
    ASSERT_TRUE(two);
    EXPECT_EQ(two->error.pairs, 2U);
    EXPECT_EQ(two->pairs.size(), 3U);
    EXPECT_FALSE(evaluateSequence(sequence, kUnfiltered, registration, 4));
}

TEST(SequenceEvaluation, CountsAScannerThatCannotBePlacedAsNotMoved) {
    Sequence sequence;
    sequence.truth = {walk()[0], walk()[3]};
    sequence.clouds = {test::room(walk()[0], 1),
                       test::room(walk()[3], 2).transformed({test::pose(500, 0, 0), 1})};
    const auto score = evaluateSequence(sequence, kUnfiltered, comparedRegistration());
    ASSERT_TRUE(score) << score.error().sentence();
    EXPECT_EQ(score->failed, 1U);
    EXPECT_NEAR(score->error.translation_m, walk()[3].translation().norm(), 1e-9);
}

TEST(EvaluationPlan, RunsEveryCombinationOnce) {
    const auto runs = evaluationRuns(
        {{{"ndt", "icp"}, {"0.5", "auto"}, {"none", "median"}}, {{"icp"}, {"0.50", "0.2"}, {"median"}}},
        ParameterSet(preprocessParameters()), ParameterSet(registrationParameters()));
    ASSERT_TRUE(runs) << runs.error().sentence();
    EXPECT_EQ(runs->size(), 9U);
    EXPECT_EQ(runs->back().registration.optionalReal("voxel_m"), 0.2);
    EXPECT_EQ(runs->back().preprocessing.text("filter"), "median");
    EXPECT_FALSE(evaluationRuns({{{"nothing"}, {"0.5"}, {"none"}}}, ParameterSet(preprocessParameters()),
                                ParameterSet(registrationParameters())));
}

TEST(EvaluationPlan, HasThePublishedTables) {
    const ParameterSet preprocessing(preprocessParameters());
    const ParameterSet registration(registrationParameters());
    EXPECT_EQ(evaluationRuns({publishedChoice(2)}, preprocessing, registration)->size(), 12U);
    EXPECT_EQ(evaluationRuns({publishedChoice(3)}, preprocessing, registration)->size(), 9U);
    EXPECT_EQ(evaluationRuns({publishedChoice(2), publishedChoice(3)}, preprocessing, registration)->size(),
              21U);
    EXPECT_EQ(evaluationRuns({publishedChoice(4)}, preprocessing, registration)->size(), 0U);
}

SequenceScore score(const std::string& method, double voxel, double rpe) {
    SequenceScore made;
    made.method = method;
    made.filter = "none";
    made.voxel_m = voxel;
    made.error.pairs = 1;
    made.error.translation_m = rpe;
    PairScore pair;
    pair.from = 4;
    pair.verdict = Verdict::doubtful;
    made.pairs.push_back(pair);
    return made;
}

TEST(SizeComparison, CountsSizesAndFindsTheWorst) {
    const std::vector<SequenceScore> scores{score("ndt", 1, 0.4), score("ndt", 0.5, 0.2),
                                            score("improved-ndt", 1, 0.2), score("improved-ndt", 0.5, 0.21),
                                            score("improved-ndt", 0.25, 0.1)};
    const auto compared = compareBySize(scores, "improved-ndt", "ndt");
    ASSERT_TRUE(compared);
    EXPECT_EQ(compared->sizes, 2U);
    EXPECT_EQ(compared->lower, 1U);
    EXPECT_DOUBLE_EQ(compared->mean_m, 0.205);
    EXPECT_DOUBLE_EQ(compared->otherMean_m, 0.3);
    EXPECT_DOUBLE_EQ(compared->worstRatio, 0.21 / 0.2);
    EXPECT_DOUBLE_EQ(compared->worstVoxel_m, 0.5);
    EXPECT_FALSE(compareBySize(scores, "icp", "ndt"));
}

TEST(SequenceCsv, ReadsBackExactly) {
    std::vector<SequenceScore> scores{score("ndt", 0.1, 1.0 / 3), score("icp", 1, 2)};
    scores[1].voxel_m.reset();
    const auto rows = parseCsv(sequenceCsv(scores), "csv");
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 3U);
    EXPECT_EQ(rows->at(0).cells[5], "rpe_m");
    EXPECT_EQ(parseReal(rows->at(1).cells[5]), 1.0 / 3);
    EXPECT_EQ(rows->at(1).cells[1], "0.1");
    EXPECT_EQ(rows->at(2).cells[1], "");
    const auto pairs = parseCsv(pairsCsv(scores), "csv");
    ASSERT_TRUE(pairs);
    ASSERT_EQ(pairs->size(), 3U);
    EXPECT_EQ(pairs->at(1).cells[3], "4");
    EXPECT_EQ(pairs->at(1).cells[4], "5");
    EXPECT_EQ(pairs->at(1).cells[9], "doubtful");
}

}  // namespace
}  // namespace vestige
