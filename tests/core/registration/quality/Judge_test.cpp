#include "core/registration/quality/Judge.h"

#include <gtest/gtest.h>

#include <limits>

namespace vestige {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// Everything speaks for the pose.
struct Case {
    RegistrationResult result;
    RegistrationQuality quality;
    Evidence evidence;

    Case() {
        result.converged = true;
        result.overlap = result.targetOverlap = 0.8;
        result.inlierDistance_m = 0.05;
        quality.restarts.runs = quality.restarts.agreeing = 4;
        quality.directions.resize(6);
        evidence.source = evidence.target = {0.7, 0.2, 0.1, 0.5, 0.6};
        evidence.score = 2.4;
        evidence.apart_m = 0.5;
        evidence.radius_m = 10;
        evidence.shift = {0.01, "slides level"};
        evidence.turn = {0.001, "turns about the vertical axis"};
    }
    Judgement judged() const { return judge(result, quality, evidence, {}); }
};

void expect(const Case& one, Verdict verdict, const std::string& reason) {
    const Judgement judgement = one.judged();
    EXPECT_EQ(judgement.verdict, verdict) << reason;
    ASSERT_FALSE(judgement.reasons.empty());
    EXPECT_NE(judgement.reasons.front().find(reason), std::string::npos) << judgement.reasons.front();
}

}  // namespace

TEST(Judge, AcceptsWhereEverythingSpeaksForThePose) {
    expect({}, Verdict::accepted, "70 % of the surface agrees");
}

TEST(Judge, OverlapOfEitherCloudWillDo) {
    Case one;
    one.result.overlap = 0.02;
    expect(one, Verdict::accepted, "agrees");
    one.result.targetOverlap = 0.05;
    expect(one, Verdict::failed, "only 2 % of the source lies within 50 mm");
}

TEST(Judge, SupportBelowItsThresholds) {
    Case one;
    one.evidence.source.support = one.evidence.target.support = 0.1;
    expect(one, Verdict::doubtful, "in one direction 10 %");
    one.evidence.source.support = one.evidence.target.support = 0.02;
    expect(one, Verdict::failed, "only 2 %");
    one.evidence.source.support = one.evidence.target.support = kNotANumber;
    EXPECT_EQ(one.judged().verdict, Verdict::failed);
}

TEST(Judge, SurfaceThatAScannerSawThrough) {
    Case one;
    one.evidence.through = 0.05;
    expect(one, Verdict::doubtful, "seen through the place of 5.0 % of the surface");
    one.evidence.through = 0.2;
    expect(one, Verdict::failed, "20.0 %");
    one.evidence.through = kNotANumber;
    EXPECT_EQ(one.judged().verdict, Verdict::failed);
}

TEST(Judge, UncertaintyAboveItsThresholds) {
    Case one;
    one.evidence.shift.size = 0.2;
    expect(one, Verdict::doubtful, "uncertain by 200 mm (95 %) where it is held least: it slides level");
    one.evidence.shift.size = kNotANumber;
    EXPECT_EQ(one.judged().verdict, Verdict::doubtful);
    Case two;
    two.evidence.turn.size = 0.03;
    expect(two, Verdict::doubtful, "1.72 degrees");
    two.evidence.radius_m = 1;  // 30 mm at the surface
    expect(two, Verdict::accepted, "agrees");
}

TEST(Judge, ABetterPoseFarFromTheResultFailsItAndANearOneDoesNot) {
    Case one;
    one.evidence.rivals = {{2, 2.7, 0, true}};
    expect(one, Verdict::failed, "2.00 m away that fits better");
    one.evidence.rivals = {{0.1, 2.7, 0, true}};
    expect(one, Verdict::accepted, "agrees");
    one.evidence.rivals = {{2, 2.35, 0, true}};
    expect(one, Verdict::doubtful, "fits as well");
    one.evidence.rivals = {{30, 2.7, 0, false}};
    expect(one, Verdict::doubtful, "fits as well");
}

TEST(Judge, AMuchBetterPoseIsNotForgottenForOneThatIsBetterStill) {
    Case one;
    one.evidence.rivals = {{2, 2.6, 0, true}, {30, 3.0, 0, false}};
    EXPECT_EQ(one.judged().verdict, Verdict::failed);
}

TEST(Judge, FreeSpaceSettlesWhichOfTwoPosesItIs) {
    Case one;
    one.evidence.rivals = {{30, 2.7, 0.02, false}};  // a scanner saw through the other one's surface
    expect(one, Verdict::accepted, "agrees");
    one.evidence.through = 0.008;
    one.evidence.rivals = {{30, 1.8, 0, false}};  // and here through this one's
    expect(one, Verdict::failed, "seen through 0.0 % only, of this one's 0.8 %");
}

TEST(Judge, MostPerturbedStartsMustComeBack) {
    Case one;
    one.quality.restarts.agreeing = 1;
    expect(one, Verdict::doubtful, "only 1 of 4 perturbed starts");
}

}  // namespace vestige
