#include "ui/document/FitTrace.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <thread>

#include "ui/document/Comparison.h"
#include "ui/document/Document.h"
#include "ui/document/Preview.h"

namespace vestige {
namespace {

RegistrationStep stepAt(int level, int iteration, double x) {
    RegistrationStep step;
    step.level = level;
    step.levels = 2;
    step.iteration = iteration;
    step.voxel_m = level == 0 ? 2 : 1;
    step.targetFromSource.pose.translation().x() = x;
    return step;
}

struct Traced {
    Document document;
    Preview preview;
    FitTrace trace{document, preview};
};

TEST(FitTrace, StepsOfAWorkerComeToTheWindowWhileItRuns) {
    Traced t;
    QSignalSpy pictures(&t.preview, &Preview::changed);
    std::atomic<bool> go = false;
    std::thread worker([watch = t.trace.begin()("scan"), &go] {
        for (int i = 0; i < 1000; ++i) watch(stepAt(i / 500, i % 500, i));
        while (!go) std::this_thread::yield();
        watch(stepAt(1, 500, 1000));
    });
    for (int i = 0; i < 100 && t.trace.steps("scan").size() < 1000; ++i) QTest::qWait(10);
    EXPECT_EQ(t.trace.steps("scan").size(), 1000u);
    EXPECT_TRUE(t.trace.live());
    EXPECT_EQ(t.preview.layer(), "scan");
    EXPECT_EQ(t.preview.sceneFromLayer().pose.translation().x(), 999) << "the latest step is shown";
    EXPECT_LT(pictures.size(), 30) << "a picture for each of 1000 steps would hold the window up";
    go = true;
    worker.join();
    t.trace.finish();
    EXPECT_EQ(t.trace.steps("scan").size(), 1001u) << "what came last is not lost";
    EXPECT_FALSE(t.preview.active());
    EXPECT_FALSE(t.trace.live());
}

TEST(FitTrace, IsReplayedStepByStep) {
    Traced t;
    const auto watches = t.trace.begin();
    for (int i = 0; i < 5; ++i) watches("scan")(stepAt(0, i, 10 * i));
    t.trace.finish();
    EXPECT_FALSE(t.trace.cursor("scan"));
    t.trace.replay("scan", 3);
    EXPECT_EQ(t.trace.cursor("scan"), 3u);
    EXPECT_EQ(t.preview.sceneFromLayer().pose.translation().x(), 30);
    EXPECT_TRUE(t.preview.words().contains("iteration 3")) << t.preview.words().toStdString();
    t.trace.replay("scan", 5);
    EXPECT_EQ(t.trace.cursor("scan"), 3u) << "there is no such step";
    t.preview.end();
    EXPECT_FALSE(t.trace.cursor("scan"));
}

TEST(FitTrace, WatchedAgainItBeginsAnew) {
    Traced t;
    for (const int steps : {7, 4}) {
        const auto watch = t.trace.begin()("scan");
        for (int i = 0; i < steps; ++i) watch(stepAt(0, i, i));
        t.trace.finish();
        EXPECT_EQ(t.trace.steps("scan").size(), static_cast<std::size_t>(steps));
    }
    t.document.replace(SceneState());
    EXPECT_TRUE(t.trace.steps("scan").empty());
}

TEST(Comparison, BlinksAndHolds) {
    Comparison comparison;
    comparison.setBlink(200);
    comparison.setMode(CompareMode::blink);
    const bool first = comparison.shown().otherShown;
    for (int i = 0; i < 100 && comparison.shown().otherShown == first; ++i) QTest::qWait(10);
    EXPECT_NE(comparison.shown().otherShown, first);
    comparison.toggleHeld();
    const bool held = comparison.shown().otherShown;
    QTest::qWait(500);
    EXPECT_EQ(comparison.shown().otherShown, held);
    EXPECT_TRUE(comparison.held());
    comparison.setMode(std::nullopt);
    EXPECT_FALSE(comparison.active());
}

TEST(Comparison, StepsWithinWhatItHas) {
    Comparison comparison;
    QSignalSpy adjusted(&comparison, &Comparison::adjusted);
    comparison.setMode(CompareMode::checkerboard);
    for (int i = 0; i < 20; ++i) comparison.step(1);
    EXPECT_EQ(comparison.shown().tile_px, 256);
    for (int i = 0; i < 20; ++i) comparison.step(-1);
    EXPECT_EQ(comparison.shown().tile_px, 24);
    comparison.setMode(CompareMode::swipe);
    for (int i = 0; i < 200; ++i) comparison.step(1);
    EXPECT_NEAR(comparison.shown().divider, 0.98, 1e-12);
    EXPECT_GT(adjusted.size(), 200);
}

}  // namespace
}  // namespace vestige
