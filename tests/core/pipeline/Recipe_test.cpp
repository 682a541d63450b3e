#include "core/pipeline/Recipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vestige {
namespace {

using testing::ElementsAre;
using Log = std::vector<std::string>;

Stage<Log> noting(const std::string& id) {
    return {id, id, 1, [id](Log& log, const JobControl&) -> Status {
                log.push_back(id);
                return {};
            }};
}

TEST(Recipe, RunsItsStagesInOrderAndTellsOfEach) {
    Log log;
    Log told;
    const Recipe<Log> recipe{noting("a"), noting("b"), noting("c")};
    ASSERT_TRUE(runRecipe(recipe, log, {}, [&](const Stage<Log>& stage, double seconds) {
        EXPECT_GE(seconds, 0);
        told.push_back(stage.id);
    }));
    EXPECT_THAT(log, ElementsAre("a", "b", "c"));
    EXPECT_THAT(told, ElementsAre("a", "b", "c"));
}

TEST(Recipe, EndsAtTheFirstError) {
    Log log;
    const Recipe<Log> recipe{noting("a"),
                             {"b", "b", 1, [](Log&, const JobControl&) -> Status { throw std::bad_alloc(); }},
                             noting("c")};
    const Status done = runRecipe(recipe, log, {}, [](const auto&, double) {});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().place, "b");
    EXPECT_THAT(log, ElementsAre("a"));
}

TEST(Recipe, StopsBetweenStagesWhenCancelledAndReportsRisingProgress) {
    double last = 0;
    const JobControl control(
        [&](double fraction, std::string_view) {
            EXPECT_GE(fraction, last);
            last = fraction;
        },
        {});
    Log log;
    const Recipe<Log> recipe{noting("a"),
                             {"b", "b", 3,
                              [](Log&, const JobControl& sub) -> Status {
                                  sub.progress(0.5);
                                  sub.cancel();
                                  return {};
                              }},
                             noting("c")};
    const Status done = runRecipe(recipe, log, control, [](const auto&, double) {});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::cancelled);
    EXPECT_THAT(log, ElementsAre("a"));
    EXPECT_DOUBLE_EQ(last, 0.5);
}

}  // namespace
}  // namespace vestige
