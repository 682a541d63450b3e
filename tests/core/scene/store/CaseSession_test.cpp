#include "core/scene/store/CaseSession.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "core/base/AtomicFile.h"
#include "core/scene/CaseFile.h"
#include "core/scene/store/Database.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

SceneState sample(const std::string& operatorName) {
    SceneState scene = test::sampleScene();
    scene.operatorName = operatorName;
    return scene;
}

class Session : public testing::Test {
  public:
    std::unique_ptr<CaseSession> open(const fs::path& file) {
        return std::make_unique<CaseSession>(autosaves, file);
    }
    /// What the next window finds of the case.
    std::string recovered(const fs::path& file) {
        const auto found = open(file)->takeRecovered();
        return found ? found->state.operatorName : "nothing";
    }

    test::TemporaryFolder folder;
    Autosaves autosaves{folder / "user"};
};

TEST_F(Session, EditsOfAJsonCaseGoToTheUsersFolderAndComeBack) {
    const fs::path file = folder / "case.json";
    ASSERT_TRUE(writeCase(file, sample("saved")));
    const std::string before = readTextFile(file).value();
    {
        const auto session = open(file);
        EXPECT_EQ(session->readOnly(), "");
        EXPECT_TRUE(session->append({{"one", sample("1")}}).kept);
        EXPECT_TRUE(session->append({{"two", sample("2")}}).kept);
        EXPECT_TRUE(autosaves.abandoned().empty()) << "its window lives";
    }
    EXPECT_EQ(readTextFile(file).value(), before);
    EXPECT_EQ(autosaves.abandoned().size(), 1u);
    auto session = open(file);
    const auto found = session->takeRecovered();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->state.operatorName, "2");
    EXPECT_THAT(found->sentence, HasSubstr("2 changes were not saved (the last: two"));
    ASSERT_TRUE(session->append({{"recover", found->state}}).kept);
    EXPECT_TRUE(autosaves.abandoned().empty()) << "it was taken over";
    ASSERT_TRUE(session->save(found->state));
    session.reset();
    EXPECT_EQ(readCase(file)->operatorName, "2");
    EXPECT_EQ(recovered(file), "nothing");
    EXPECT_TRUE(fs::is_empty(folder / "user"));
}

TEST_F(Session, EditsOfAStoreStayWithIt) {
    const fs::path file = folder / "night.vestige";
    ASSERT_TRUE(writeCase(file, sample("saved")));
    open(file)->append({{"one", sample("1")}});
    EXPECT_FALSE(fs::exists(folder / "user"));
    EXPECT_EQ(recovered(file), "1");
    open(file)->discard();
    EXPECT_EQ(recovered(file), "nothing");
    EXPECT_EQ(readCase(file)->operatorName, "saved");
}

TEST_F(Session, TheSecondMayLookAndSaveElsewhere) {
    for (const char* name : {"night.vestige", "case.json"}) {
        const fs::path file = folder / name;
        ASSERT_TRUE(writeCase(file, sample("saved")));
        const auto first = open(file);
        ASSERT_TRUE(first->append({{"one", sample("1")}}).kept);
        const auto second = open(file);
        EXPECT_THAT(second->readOnly(), HasSubstr("open in another window since "));
        EXPECT_FALSE(second->takeRecovered()) << "the edits are the other window's";
        EXPECT_FALSE(second->save(sample("second")));
        EXPECT_TRUE(second->append({{"two", sample("2")}}).kept) << "in the user's folder";
        EXPECT_EQ(readCase(file)->operatorName, "saved");
        EXPECT_TRUE(first->save(sample("first")));
        second->discard();
        first->discard();
    }
}

TEST_F(Session, OlderEditsOfASecondWindowStayUntilThoseOfTheFirstAreSettled) {
    const fs::path file = folder / "night.vestige";
    ASSERT_TRUE(writeCase(file, sample("saved")));
    auto first = open(file);
    auto second = open(file);
    ASSERT_TRUE(second->append({{"two", sample("2")}}).kept);
    ASSERT_TRUE(first->append({{"one", sample("1")}}).kept);
    second.reset();
    first.reset();
    {
        const auto next = open(file);
        const auto found = next->takeRecovered();
        ASSERT_TRUE(found);
        EXPECT_EQ(found->state.operatorName, "1");
        ASSERT_TRUE(next->append({{"recover", found->state}}).kept);
        ASSERT_EQ(autosaves.abandoned().size(), 1u) << "nobody has seen them";
        ASSERT_TRUE(next->save(found->state));
    }
    EXPECT_EQ(recovered(file), "2");
}

TEST_F(Session, AnUntitledCaseIsKeptAndTakenOver) {
    CaseSession(autosaves).append({{"one", sample("1")}});
    const auto left = autosaves.abandoned();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].content.caseFile, "");
    CaseSession next(autosaves);
    ASSERT_TRUE(next.takeOver(left[0]));
    const auto found = next.takeRecovered();
    ASSERT_TRUE(found);
    EXPECT_EQ(caseText(found->state), caseText(sample("1")));
    EXPECT_TRUE(fs::exists(left[0].folder)) << "until it is kept anew";
    next.append({{"recover", found->state}});
    EXPECT_FALSE(fs::exists(left[0].folder));
}

TEST_F(Session, WhatCannotBeReadIsNotTakenOverAndStays) {
    for (const char* name : {"", "case.json"}) {
        const fs::path file = folder / name;
        const bool untitled = std::string(name).empty();
        if (!untitled) {
            ASSERT_TRUE(writeCase(file, sample("saved")));
        }
        {
            CaseSession killed = untitled ? CaseSession(autosaves) : CaseSession(autosaves, file);
            killed.append({{"one", sample("1")}});
        }
        const auto left = autosaves.abandoned();
        ASSERT_EQ(left.size(), 1u);
        Database(left[0].folder / "case.db", Database::Access::write)
            .run("UPDATE journal SET case_text='{ half'");
        if (untitled) {
            CaseSession next(autosaves);
            const Status taken = next.takeOver(autosaves.abandoned().at(0));
            ASSERT_FALSE(taken);
            EXPECT_EQ(taken.error().code, ErrorCode::input);
            EXPECT_FALSE(next.takeRecovered());
            EXPECT_TRUE(next.append({{"two", sample("2")}}).kept);
            next.discard();
        } else {
            const auto next = open(file);
            EXPECT_FALSE(next->takeRecovered());
            EXPECT_TRUE(next->append({{"two", sample("2")}}).kept);
            EXPECT_TRUE(next->save(sample("2")));
        }
        EXPECT_TRUE(fs::exists(left[0].folder / "case.db")) << name;
        Autosaves::remove(left[0].folder);
    }
}

/// A file system that cannot be written, or has little room.
class Mounted {
  public:
    Mounted(const fs::path& at, const char* options) : at_(at) {
        fs::create_directories(at);
        mounted_ = ::mount("none", at.c_str(), "tmpfs", 0, options) == 0;
    }
    ~Mounted() {
        if (mounted_) ::umount2(at_.c_str(), MNT_DETACH);
    }
    explicit operator bool() const { return mounted_; }
    void makeReadOnly(bool on) {
        EXPECT_EQ(::mount("none", at_.c_str(), "tmpfs", MS_REMOUNT | (on ? MS_RDONLY : 0), nullptr), 0);
    }

  private:
    fs::path at_;
    bool mounted_ = false;
};

TEST_F(Session, OnAReadOnlyMediumItOpensAndEditsGoToTheUser) {
    const fs::path medium = folder / "medium";
    Mounted mounted(medium, "size=4m");
    if (!mounted) GTEST_SKIP() << "nothing to run: mounting takes rights that are not here";
    for (const char* name : {"night.vestige", "case.json"}) {
        const fs::path file = medium / name;
        mounted.makeReadOnly(false);
        ASSERT_TRUE(writeCase(file, sample("saved")));
        mounted.makeReadOnly(true);
        EXPECT_EQ(readCase(file)->operatorName, "saved");
        auto session = open(file);
        EXPECT_THAT(session->readOnly(), HasSubstr("cannot be written here"));
        const Status saved = session->save(sample("new"));
        ASSERT_FALSE(saved);
        EXPECT_THAT(saved.error().sentence(), HasSubstr("cannot be written here"));
        EXPECT_TRUE(session->append({{"one", sample("1")}}).kept);
        session.reset();
        EXPECT_EQ(recovered(file), "1") << "when the same user opens it again";
    }
}

TEST_F(Session, OnAFullDiskEditsGoToTheUserUntilThereIsRoomAgain) {
    const fs::path medium = folder / "medium";
    const Mounted mounted(medium, "size=512k");
    if (!mounted) GTEST_SKIP() << "nothing to run: mounting takes rights that are not here";
    const fs::path file = medium / "night.vestige";
    ASSERT_TRUE(writeCase(file, sample("saved")));
    auto session = open(file);
    ASSERT_TRUE(session->append({{"one", sample("1")}}).kept);
    // Whatever is left.
    std::string filler(1024, 'x');
    int written = 0;
    while (writeTextFile(medium / ("filler-" + std::to_string(written)), filler)) ++written;
    const auto kept = session->append({{"two", sample(std::string(60000, '2'))}});
    EXPECT_TRUE(kept.kept) << kept.problem;
    EXPECT_THAT(kept.problem, testing::AnyOf(HasSubstr("full"), HasSubstr("No space")));
    const Status saved = session->save(sample(std::string(60000, '2')));
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().code, ErrorCode::output);
    EXPECT_EQ(readCase(file)->operatorName, "saved") << "nothing of it is lost or half there";
    EXPECT_THAT(session->append({{"three", sample("3")}}).problem, testing::Not(HasSubstr("damaged")));
    session.reset();
    EXPECT_EQ(recovered(file), "3") << "from the user's folder or with the case";

    session = open(file);
    for (int i = 0; i < written; ++i) fs::remove(medium / ("filler-" + std::to_string(i)));
    const auto again = session->append({{"four", sample("4")}});
    EXPECT_TRUE(again.kept);
    EXPECT_EQ(again.problem, "");
    EXPECT_TRUE(autosaves.abandoned().empty());
    EXPECT_TRUE(session->save(sample("4")));
}

TEST_F(Session, WhereNothingCanBeWrittenItSaysSoAndGoesOnWhenItCan) {
    // A limit on file sizes does what a full disk does, without any rights.
    const fs::path file = folder / "night.vestige";
    ASSERT_TRUE(writeCase(file, sample("saved")));
    auto session = open(file);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit none = before;
    none.rlim_cur = 1000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &none), 0);
    const auto failed = session->append({{"one", sample("1")}});
    const Status saved = session->save(sample("1"));
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(failed.kept);
    EXPECT_THAT(failed.problem, HasSubstr("night.vestige"));
    EXPECT_FALSE(saved);
    EXPECT_EQ(readCase(file)->operatorName, "saved");
    EXPECT_TRUE(session->append({}).kept) << "what could not be kept is tried again";
    session.reset();
    EXPECT_EQ(recovered(file), "1");
}

}  // namespace
}  // namespace vestige
