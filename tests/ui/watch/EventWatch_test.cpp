#include "ui/watch/EventWatch.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QEventLoop>
#include <QTest>
#include <QTimer>
#include <atomic>
#include <thread>

#include "ui/watch/AnswerWatch.h"

namespace vestige {
namespace {

void work(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// Called by an event of its own.
void byAnEvent(const std::function<void()>& task) {
    bool done = false;
    QObject context;
    context.setObjectName("context");
    QMetaObject::invokeMethod(
        &context,
        [&] {
            task();
            done = true;
        },
        Qt::QueuedConnection);
    while (!done) QTest::qWait(1);
}

TEST(EventWatch, NamesWhatHeldTheThread) {
    EventWatch watch;
    byAnEvent([] {
        const WatchedTime slow("sorting", "names");
        work(60);
    });
    ASSERT_FALSE(watch.held().empty());
    const EventWatch::Held worst = watch.held().front();
    EXPECT_GE(worst.worst_s, 0.06);
    EXPECT_EQ(worst.what, "QObject MetaCall 'context' > sorting 'names'");
    EXPECT_EQ(worst.times, 1);
    EXPECT_GT(watch.events(), 0);
    EXPECT_TRUE(watch.report().front().contains("at most"));
    watch.forget();
    EXPECT_TRUE(watch.held().empty());
    EXPECT_EQ(watch.worst_s(), 0);
}

TEST(EventWatch, CountsDrawingApart) {
    EventWatch watch;
    byAnEvent([] {
        work(20);
        const DrawingTime drawing;
        work(300);
    });
    EXPECT_GE(watch.worstDrawing_s(), 0.3);
    EXPECT_GE(watch.worst_s(), 0.02);
    EXPECT_LT(watch.worst_s(), 0.3);
}

TEST(EventWatch, ADialogsLoopIsNoBlock) {
    EventWatch watch;
    byAnEvent([] {
        QEventLoop loop;
        QTimer::singleShot(400, &loop, &QEventLoop::quit);
        loop.exec();
    });
    EXPECT_LT(watch.worst_s(), 0.4);
}

TEST(EventWatch, AnEventOfADialogsLoopCountsForItself) {
    EventWatch watch;
    byAnEvent([] {
        QEventLoop loop;
        QTimer::singleShot(10, &loop, [&] {
            work(80);
            loop.quit();
        });
        loop.exec();
    });
    int long_ = 0;
    for (const auto& held : watch.held()) long_ += held.worst_s >= 0.08 ? held.times : 0;
    EXPECT_EQ(long_, 1) << "not in the event with the loop as well";
}

TEST(EventWatch, WatchesNothingWhereThereIsNone) {
    ASSERT_EQ(EventWatch::current(), nullptr);
    byAnEvent([] { const WatchedTime quick("nothing"); });
    EventWatch watch;
    std::thread other([] { const WatchedTime elsewhere("another thread"); });
    other.join();
    EXPECT_EQ(watch.events(), 0);
}

TEST(AnswerWatch, TellsWhileTheThreadDoesNotAnswer) {
    EventWatch watch;
    std::atomic<int> told = 0;
    {
        const AnswerWatch answers(watch, 0.05, [&](double held_s) {
            EXPECT_GE(held_s, 0.05);
            ++told;
        });
        byAnEvent([&] {
            for (int i = 0; i < 200 && told == 0; ++i) work(50);
        });
    }
    EXPECT_GE(told, 1);
}

}  // namespace
}  // namespace vestige
