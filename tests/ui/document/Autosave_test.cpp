#include "ui/document/Autosave.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QTest>
#include <chrono>
#include <csignal>
#include <fstream>
#include <optional>
#include <thread>

#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "tests/support/TestPaths.h"
#include "ui/document/Document.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A disk that does not answer, as long as this lives: who writes to the case looks for a journal of a killed
/// writer first, and a pipe in its place is waited for without end.
class HungDisk {
  public:
    explicit HungDisk(const fs::path& place) : pipe_(place / "case.db-journal"), aside_(place / "answer") {
        EXPECT_EQ(::mkfifo(pipe_.c_str(), 0600), 0);
    }
    ~HungDisk() {
        fs::rename(pipe_, aside_);
        const int end = ::open(aside_.c_str(), O_RDWR | O_CLOEXEC);
        ::close(end);
        fs::remove(aside_);
    }

  private:
    fs::path pipe_, aside_;
};

/// Only a failure takes that long, on however busy a machine.
constexpr int kLong_ms = 60000;

class AutosaveTest : public testing::Test {
  public:
    AutosaveTest() {
        autosave->setPatience(kLong_ms);
        EXPECT_TRUE(autosave->save(place));
    }
    void edit(const std::string& operatorName) {
        document.perform(setCaseDetails("night", operatorName, {}));
    }
    /// What the next window finds, once the writer of this one has done with the case.
    std::string recovered() const {
        for (int i = 0; i < kLong_ms / 100 && fs::exists(place / "lock"); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        const auto found = CaseSession(Autosaves(folder / "user"), place).takeRecovered();
        return found ? found->state.operatorName : "nothing";
    }

    test::TemporaryFolder folder;
    fs::path place = folder / "night.vestige";
    Document document;
    std::unique_ptr<Autosave> autosave = std::make_unique<Autosave>(document, folder / "user");
};

TEST_F(AutosaveTest, SavingIsRefusedWhileEarlierEditsAreNotWritten) {
    autosave->setPatience(200);
    auto hung = std::make_unique<HungDisk>(place);
    edit("me");
    const Status saved = autosave->save(place);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().code, ErrorCode::output);
    EXPECT_THAT(saved.error().sentence(), HasSubstr("has not yet taken the changes"));
    EXPECT_TRUE(document.modified());
    EXPECT_TRUE(autosave->save(folder / "other.vestige")) << "elsewhere it goes on";
    hung.reset();
    ASSERT_TRUE(autosave->flush(kLong_ms));
    ASSERT_TRUE(autosave->save(place));
    EXPECT_EQ(readCase(place)->operatorName, "me");
}

TEST_F(AutosaveTest, ADiskThatDoesNotAnswerIsNotWaitedForAtTheEndAndThatIsTold) {
    autosave->setPatience(200);
    auto hung = std::make_unique<HungDisk>(place);
    edit("me");
    testing::internal::CaptureStderr();
    autosave.reset();
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                HasSubstr("the last changes (1) are not stored: the disk does not answer"));
    hung.reset();
    EXPECT_EQ(recovered(), "me") << "it is written when the disk does answer";
}

TEST_F(AutosaveTest, WhatIsStoredSavedOrDiscardedIsNotComplainedOf) {
    testing::internal::CaptureStderr();
    edit("me");
    autosave.reset();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(recovered(), "me");
}

TEST_F(AutosaveTest, LeavingForGoodDoesNotWaitEitherAndTellsThatEditsMayBeOfferedAgain) {
    autosave->setPatience(200);
    QString told;
    QObject::connect(autosave.get(), &Autosave::troubled, [&](const QString& sentence) { told = sentence; });
    auto hung = std::make_unique<HungDisk>(place);
    edit("discarded");
    testing::internal::CaptureStderr();
    autosave->end();
    autosave.reset();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "nobody wants them";
    EXPECT_THAT(told.toStdString(), HasSubstr("may be offered once more"));
    hung.reset();
    EXPECT_EQ(recovered(), "nothing") << "forgotten when the disk does answer";
}

TEST_F(AutosaveTest, SavingAsThatFailsLeavesNothing) {
    // A limit on file sizes does what a full disk does, without any rights.
    edit(std::string(60000, 'x'));
    ASSERT_TRUE(autosave->flush(kLong_ms));
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    for (const rlim_t most : {1000, 45000})
        for (const char* name : {"new.vestige", "new/case.json"}) {
            rlimit little = before;
            little.rlim_cur = most;
            ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
            const Status saved = autosave->save(folder / name);
            ::setrlimit(RLIMIT_FSIZE, &before);
            EXPECT_FALSE(saved) << name;
            EXPECT_FALSE(fs::exists(folder / fs::path(name).begin()->string())) << name << most;
        }
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(document.state().file, place);
    EXPECT_TRUE(autosave->save(folder / "new.vestige"));
}

/// Of a save that goes on beside the editing.
class SavingAside : public AutosaveTest {
  public:
    void begin(const fs::path& file) {
        told.reset();
        autosave->saveAside(file, [this](const Status& status) { told = status; });
    }
    void settle() {
        for (int i = 0; i < kLong_ms / 10 && !told; ++i) QTest::qWait(10);
        ASSERT_TRUE(told) << "nobody was told";
        EXPECT_FALSE(autosave->saving());
    }
    std::optional<Status> told;
};

TEST_F(SavingAside, TakesTheCaseAsItWasAndEditsGoOn) {
    edit("one");
    begin(place);
    edit("two");
    EXPECT_TRUE(autosave->saving());
    EXPECT_EQ(autosave->text(), "Saving…");
    settle();
    ASSERT_TRUE(*told) << told->error().sentence();
    EXPECT_EQ(readCase(place)->operatorName, "one");
    EXPECT_EQ(document.state().operatorName, "two");
    EXPECT_TRUE(document.modified());
    document.undo();
    EXPECT_FALSE(document.modified());
    document.redo();
    ASSERT_TRUE(autosave->flush(kLong_ms));
    autosave.reset();
    EXPECT_EQ(recovered(), "two") << "the edit after the save is kept";
}

TEST_F(SavingAside, ElsewhereTheEditsMadeMeanwhileGoAlong) {
    const fs::path other = folder / "other.vestige";
    edit("one");
    begin(other);
    edit("two");
    settle();
    ASSERT_TRUE(*told) << told->error().sentence();
    EXPECT_EQ(document.state().file, other);
    EXPECT_EQ(readCase(other)->operatorName, "one");
    EXPECT_TRUE(document.modified());
    ASSERT_TRUE(autosave->flush(kLong_ms));
    autosave.reset();
    EXPECT_EQ(recovered(), "nothing") << "the case before has no edits any more";
    const auto found = CaseSession(Autosaves(folder / "user"), other).takeRecovered();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->state.operatorName, "two");
}

TEST_F(SavingAside, WaitsForTheDiskWithoutHoldingTheWindow) {
    auto hung = std::make_unique<HungDisk>(place);
    edit("one");
    begin(place);
    edit("two");
    QTest::qWait(50);
    EXPECT_FALSE(told);
    hung.reset();
    settle();
    EXPECT_TRUE(*told);
    EXPECT_EQ(readCase(place)->operatorName, "one");
}

TEST_F(SavingAside, OneAfterTheOther) {
    edit("one");
    begin(place);
    const fs::path other = folder / "other.vestige";
    edit("two");
    std::optional<Status> second;
    autosave->saveAside(other, [&](const Status& status) { second = status; });
    for (int i = 0; i < kLong_ms / 10 && !second; ++i) QTest::qWait(10);
    ASSERT_TRUE(told && second);
    EXPECT_TRUE(*told);
    ASSERT_TRUE(*second) << second->error().sentence();
    EXPECT_EQ(readCase(place)->operatorName, "one");
    EXPECT_EQ(readCase(other)->operatorName, "two");
    EXPECT_FALSE(document.modified());
}

TEST_F(SavingAside, ACaseThatIsLeftMeanwhileIsSavedAndLeft) {
    edit("one");
    begin(place);
    document.replace(SceneState());
    settle();
    EXPECT_TRUE(*told);
    EXPECT_EQ(readCase(place)->operatorName, "one");
    EXPECT_TRUE(document.state().file.empty());
    EXPECT_FALSE(document.modified());
}

TEST_F(SavingAside, FailuresAreToldAndChangeNothing) {
    edit("one");
    std::ofstream(folder / "a file") << "no folder";
    begin(folder / "a file" / "night.vestige");
    settle();
    ASSERT_FALSE(*told);
    EXPECT_EQ(told->error().code, ErrorCode::output);
    EXPECT_EQ(document.state().file, place);
    EXPECT_TRUE(document.modified());
}

}  // namespace
}  // namespace vestige
