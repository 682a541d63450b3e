#include <gtest/gtest.h>

#include <QEventLoop>
#include <QTest>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "ui/jobs/InlineJobRunner.h"
#include "ui/jobs/ThreadedJobRunner.h"

namespace vestige {
namespace {

/// Both runners pass this one list.
template <class Runner>
class JobRunners : public testing::Test {
  public:
    void finish() {
        for (int i = 0; i < 500 && runner.busy(); ++i) QTest::qWait(10);
        ASSERT_FALSE(runner.busy());
    }
    Runner runner;
};
using Kinds = testing::Types<InlineJobRunner, ThreadedJobRunner>;
TYPED_TEST_SUITE(JobRunners, Kinds);

TYPED_TEST(JobRunners, DeliversOnTheOwnersThread) {
    int got = 0;
    std::thread::id deliveredOn;
    this->runner.template run<int>(
        "six by seven", [](const JobControl&) -> Result<int> { return 42; },
        [&](Result<int> result) {
            got = result.value_or(-1);
            deliveredOn = std::this_thread::get_id();
        });
    this->finish();
    EXPECT_EQ(got, 42);
    EXPECT_EQ(deliveredOn, std::this_thread::get_id());
}

TYPED_TEST(JobRunners, TurnsExceptionsIntoErrors) {
    std::string sentence;
    this->runner.template run<int>(
        "dividing", [](const JobControl&) -> Result<int> { throw std::runtime_error("the divisor is zero"); },
        [&](Result<int> result) { sentence = result.error().sentence(); });
    this->finish();
    EXPECT_NE(sentence.find("the divisor is zero"), std::string::npos) << sentence;
}

TYPED_TEST(JobRunners, HandsOverPartsBeforeTheResult) {
    std::string order;
    this->runner.template runInParts<std::string, int>(
        "counting",
        [](const JobControl&, const std::function<void(int)>& show) -> Result<std::string> {
            for (int i = 1; i <= 3; ++i) show(i);
            return std::string("end");
        },
        [&order](int part) { order += std::to_string(part); },
        [&order](Result<std::string> result) { order += *result; });
    this->finish();
    EXPECT_EQ(order, "123end");
}

TYPED_TEST(JobRunners, RunsInOrder) {
    std::string order;
    for (const char* name : {"a", "b", "c"})
        this->runner.template run<std::string>(
            name, [name](const JobControl&) -> Result<std::string> { return std::string(name); },
            [&order](Result<std::string> result) { order += *result; });
    this->finish();
    EXPECT_EQ(order, "abc");
}

TYPED_TEST(JobRunners, TellsStartProgressMessageAndEnd) {
    QStringList told;
    auto& runner = this->runner;
    QObject::connect(&runner, &JobRunner::started, [&](const QString& title) { told << "start " + title; });
    QObject::connect(&runner, &JobRunner::progressed, [&](double fraction, const QString& step) {
        told << QString::number(fraction) + " " + step;
    });
    QObject::connect(&runner, &JobRunner::messaged, [&](const QString& text) { told << text; });
    QObject::connect(&runner, &JobRunner::finished, [&](const QString& title) { told << "end " + title; });
    runner.template run<int>(
        "job",
        [](const JobControl& control) -> Result<int> {
            control.progress(0.5, "half");
            control.message("a word");
            return 1;
        },
        [&](Result<int>) { told << "done"; });
    this->finish();
    EXPECT_EQ(told, (QStringList{"start job", "0.5 half", "a word", "done", "end job"}));
}

TYPED_TEST(JobRunners, CancelledFromItsOwnProgressEndsAsCancelled) {
    auto& runner = this->runner;
    QObject::connect(&runner, &JobRunner::progressed, [&] { runner.cancel(); });
    ErrorCode code = ErrorCode::input;
    runner.template run<int>(
        "long",
        [](const JobControl& control) -> Result<int> {
            control.progress(0.1, "begun");
            for (int i = 0; i < 1000 && !control.cancelled(); ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            if (control.cancelled()) return fail(cancelledError());
            return 1;
        },
        [&](Result<int> result) { code = result ? ErrorCode::input : result.error().code; });
    this->finish();
    EXPECT_EQ(code, ErrorCode::cancelled);
}

TYPED_TEST(JobRunners, JobsMayStartJobs) {
    auto& runner = this->runner;
    int second = 0;
    runner.template run<int>(
        "first", [](const JobControl&) -> Result<int> { return 1; },
        [&](Result<int> first) {
            runner.template run<int>(
                "second", [first](const JobControl&) -> Result<int> { return *first + 1; },
                [&](Result<int> result) { second = *result; });
        });
    this->finish();
    EXPECT_EQ(second, 2);
}

TEST(ThreadedJobRunner, WorksElsewhereWhileEventsRun) {
    ThreadedJobRunner runner;
    std::atomic<bool> release = false;
    std::thread::id workedOn;
    bool done = false;
    runner.run<int>(
        "waiting",
        [&](const JobControl&) -> Result<int> {
            workedOn = std::this_thread::get_id();
            while (!release) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return 1;
        },
        [&](Result<int>) { done = true; });
    QTest::qWait(30);
    EXPECT_TRUE(runner.busy());
    EXPECT_FALSE(done);
    release = true;
    for (int i = 0; i < 500 && !done; ++i) QTest::qWait(10);
    EXPECT_TRUE(done);
    EXPECT_NE(workedOn, std::this_thread::get_id());
}

TEST(ThreadedJobRunner, DestroyedWhileBusyStopsAndDeliversNothing) {
    bool delivered = false;
    {
        ThreadedJobRunner runner;
        runner.run<int>(
            "endless",
            [](const JobControl& control) -> Result<int> {
                while (!control.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                return fail(cancelledError());
            },
            [&](Result<int>) { delivered = true; });
        QTest::qWait(20);
    }
    QTest::qWait(20);
    EXPECT_FALSE(delivered);
}

}  // namespace
}  // namespace vestige
