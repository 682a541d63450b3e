#include "core/scene/store/CaseStore.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "core/base/AtomicFile.h"
#include "core/base/Hash.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "core/scene/store/Database.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

SceneState sample(const std::string& operatorName = "A. Nalyst") {
    SceneState scene = test::sampleScene();
    scene.operatorName = operatorName;
    return scene;
}

std::unique_ptr<CaseStore> opened(const fs::path& folder) {
    auto store = CaseStore::open(folder);
    EXPECT_TRUE(store) << store.error().sentence();
    return store ? std::move(*store) : nullptr;
}

TEST(CaseStore, WhatIsSavedIsWhatIsRead) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    const SceneState scene = sample();
    ASSERT_TRUE(writeCase(place, scene));
    const auto read = readCase(place);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(caseText(*read), caseText(scene));
    EXPECT_TRUE(fs::exists(place / "case.db"));
    EXPECT_FALSE(fs::exists(place / "lock")) << "nobody has it open";
    // The readable copy is a case of its own, and the same one.
    fs::copy_file(place / "case.json", folder / "copy.json");
    EXPECT_EQ(readTextFile(place / "case.json").value().size(), fs::file_size(folder / "copy.json"));
    const auto content = caseContent(place);
    ASSERT_TRUE(content);
    EXPECT_EQ(content->first, place / "case.json");
    EXPECT_EQ(content->second, sha256OfFile(place / "case.json").value());
}

TEST(CaseStore, EveryNameOfTheCaseMeansTheStore) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    ASSERT_TRUE(writeCase(place, sample("first")));
    for (const fs::path& name : {place, place / "", place / "case.json", place / "../night.vestige"}) {
        EXPECT_EQ(casePlace(name), fs::canonical(place)) << name;
        EXPECT_EQ(readCase(name)->operatorName, "first") << name;
    }
    EXPECT_EQ(casePlace(folder / "other.json"), fs::canonical(folder.path()) / "other.json");
}

TEST(CaseStore, UnsavedEditsAreKeptBesideTheSavedCase) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    {
        const auto store = opened(place);
        ASSERT_TRUE(store->save(sample("saved")));
        ASSERT_TRUE(store->append({{"first", sample("1")}, {"second", sample("2")}}));
        ASSERT_TRUE(store->append({{"third", sample("3")}}));
    }
    const auto stored = readCaseStore(place);
    ASSERT_TRUE(stored);
    EXPECT_EQ(stored->unsaved, 3);
    EXPECT_EQ(stored->lastEdit, "third");
    ASSERT_EQ(stored->drafts.size(), 2u);
    EXPECT_THAT(stored->drafts.front(), HasSubstr(R"("operator": "3")"));
    std::vector<std::string> warnings;
    EXPECT_EQ(readCase(place, &warnings)->operatorName, "saved");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], HasSubstr("3 changes were not saved (the last: third, "));
}

TEST(CaseStore, SavingAndDiscardingEndTheDrafts) {
    const TemporaryFolder folder;
    const auto store = opened(folder / "night.vestige");
    ASSERT_TRUE(store->append({{"before the first save", sample("0")}}));
    EXPECT_EQ(readCaseStore(store->folder())->unsaved, 1);
    ASSERT_TRUE(store->save(sample("saved")));
    EXPECT_EQ(readCaseStore(store->folder())->unsaved, 0);
    ASSERT_TRUE(store->append({{"one", sample("1")}}));
    ASSERT_TRUE(store->discard());
    EXPECT_TRUE(readCaseStore(store->folder())->drafts.empty());
    EXPECT_EQ(readCase(store->folder())->operatorName, "saved");
    ASSERT_TRUE(store->append({{"two", sample("2")}}));
    EXPECT_EQ(readCaseStore(store->folder())->unsaved, 1) << "those that were discarded do not count";
    ASSERT_TRUE(store->append({{"undo two", sample("saved")}}));
    EXPECT_EQ(readCaseStore(store->folder())->unsaved, 0) << "back at what was saved";
}

TEST(CaseStore, StaysSmallOverManyEdits) {
    const TemporaryFolder folder;
    const auto store = opened(folder / "night.vestige");
    ASSERT_TRUE(store->save(sample()));
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(store->append({{"edit", sample(std::to_string(i))}}));
    const auto after20 = fs::file_size(store->folder() / "case.db");
    for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(store->append({{"edit", sample(std::to_string(i))}}));
        if (i % 10 != 0) continue;
        ASSERT_TRUE(store->save(sample(std::to_string(i))));
    }
    EXPECT_LT(fs::file_size(store->folder() / "case.db"), 4 * after20);
}

TEST(CaseStore, AFolderWithCaseJsonIsReadAndBecomesAStoreWhenSaved) {
    const TemporaryFolder folder;
    const fs::path place = folder / "old.vestige";
    ASSERT_TRUE(writeTextFile(place / "case.json", R"({"vestige":1,"operator":"before"})"));
    EXPECT_EQ(readCase(place)->operatorName, "before");
    EXPECT_FALSE(fs::exists(place / "case.db")) << "reading changes nothing";
    ASSERT_TRUE(writeCase(place, sample("after")));
    EXPECT_EQ(readCase(place)->operatorName, "after");
    EXPECT_EQ(readTextFile(place / "case-before-1.json").value(), R"({"vestige":1,"operator":"before"})");
}

/// Saves in a process of its own, which may write no file larger than `bytes`: at that write the system kills
/// it, or the disk is full.
void saveWithLittleRoom(const fs::path& place, const SceneState& scene, rlim_t bytes, bool killed) {
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit none{0, 0}, little{bytes, bytes};
        ::setrlimit(RLIMIT_CORE, &none);
        ::signal(SIGXFSZ, killed ? SIG_DFL : SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &little);
        ::_exit(writeCase(place, scene) ? 0 : 3);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(killed ? WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ : WIFEXITED(status)) << status;
}

TEST(CaseStore, AFolderWithCaseJsonOpensAfterItsFirstSaveWasKilledOrFoundTheDiskFull) {
    const std::string old = R"({"vestige":1,"operator":"before"})";
    const std::string after(100000, 'a');
    int untouched = 0;
    for (const bool killed : {true, false})
        for (rlim_t bytes = 0; bytes < 130000; bytes += 7000) {
            const TemporaryFolder folder;
            const fs::path place = folder / "old.vestige";
            ASSERT_TRUE(writeTextFile(place / "case.json", old));
            if (killed && bytes > 100000) continue;  // it may get through
            saveWithLittleRoom(place, sample(after), bytes, killed);
            const auto read = readCase(place);
            ASSERT_TRUE(read) << bytes << killed << ": " << read.error().sentence();
            EXPECT_TRUE(read->operatorName == "before" || read->operatorName == after) << bytes << killed;
            untouched += readTextFile(place / "case.json").value_or("") == old;
            ASSERT_TRUE(writeCase(place, sample("next")));
            EXPECT_EQ(readCase(place)->operatorName, "next") << bytes << killed;
            EXPECT_EQ(readTextFile(place / "case-before-1.json").value_or("none"), old) << bytes << killed;
        }
    EXPECT_GT(untouched, 20) << "most of them stopped before the case was saved";
}

TEST(CaseStore, APipeInPlaceOfTheCopyIsNotWaitedFor) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    ASSERT_TRUE(writeCase(place, sample("ours")));
    fs::remove(place / "case.json");
    ASSERT_EQ(::mkfifo((place / "case.json").c_str(), 0600), 0);
    EXPECT_EQ(readCase(place)->operatorName, "ours");
    ASSERT_TRUE(writeCase(place, sample("ours again")));
    EXPECT_TRUE(fs::is_regular_file(place / "case.json"));
    EXPECT_TRUE(fs::is_fifo(place / "case-before-1.json"));
}

TEST(CaseStore, ACopyThatSomebodyEditedIsToldAndKept) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    ASSERT_TRUE(writeCase(place, sample("ours")));
    ASSERT_TRUE(writeTextFile(place / "case.json", R"({"vestige":1,"operator":"theirs"})"));
    std::vector<std::string> warnings;
    EXPECT_EQ(readCase(place, &warnings)->operatorName, "ours");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], HasSubstr("changed by another program"));
    ASSERT_TRUE(writeCase(place, sample("ours again")));
    EXPECT_THAT(readTextFile(place / "case-before-1.json").value(), HasSubstr("theirs"));
    warnings.clear();
    EXPECT_EQ(readCase(place, &warnings)->operatorName, "ours again");
    EXPECT_TRUE(warnings.empty());
}

TEST(CaseStore, IsOpenOnceAndTheSecondIsToldWho) {
    const TemporaryFolder folder;
    const auto store = opened(folder / "night.vestige");
    ASSERT_TRUE(store->save(sample("first")));
    const auto second = CaseStore::open(store->folder());
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::output);
    EXPECT_THAT(second.error().sentence(), HasSubstr("open in another window since "));
    EXPECT_THAT(second.error().sentence(), HasSubstr("process " + std::to_string(::getpid())));
    EXPECT_FALSE(writeCase(store->folder(), sample("second")));
    EXPECT_EQ(readCase(store->folder())->operatorName, "first") << "others may read";
}

TEST(CaseStore, TheLockOfAKilledProcessIsNone) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto store = CaseStore::open(place);
        if (!store || !(*store)->save(sample("killed")) || ::write(ready[1], "x", 1) != 1) ::_exit(3);
        ::pause();
    }
    char saved = 0;
    ASSERT_EQ(::read(ready[0], &saved, 1), 1);
    const auto refused = CaseStore::open(place);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("process " + std::to_string(child)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(fs::exists(place / "lock")) << "its file is still there";
    EXPECT_TRUE(CaseStore::open(place));
    EXPECT_EQ(readCase(place)->operatorName, "killed");
}

TEST(CaseStore, ThatWasMovedAwayIsMissedAndNothingIsTakenForStored) {
    const TemporaryFolder folder;
    const auto store = opened(folder / "night.vestige");
    ASSERT_TRUE(store->save(sample()));
    fs::rename(store->folder(), folder / "elsewhere.vestige");
    const Status stored = store->append({{"edit", sample("lost?")}});
    ASSERT_FALSE(stored);
    EXPECT_THAT(stored.error().sentence(), HasSubstr("moved or deleted"));
    fs::rename(folder / "elsewhere.vestige", store->folder());
    EXPECT_TRUE(store->append({{"edit", sample("found")}})) << "and it goes on when it is back";
}

TEST(CaseStore, ALaterVersionsCaseIsRefusedByName) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    ASSERT_TRUE(writeCase(place, sample()));
    Database(place / "case.db", Database::Access::write).run("PRAGMA user_version=99");
    const auto read = readCase(place);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().sentence(), HasSubstr("later version"));
    EXPECT_THAT(read.error().sentence(), HasSubstr(place.string()));
    const auto opened = CaseStore::open(place);
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().sentence(), HasSubstr(place.string()));
}

TEST(CaseStore, DamagedDatabasesAreRefusedWithASentence) {
    const TemporaryFolder folder;
    const fs::path place = folder / "night.vestige";
    ASSERT_TRUE(writeCase(place, sample()));
    const std::string whole = readTextFile(place / "case.db").value();
    for (std::size_t at = 0; at < whole.size(); at += whole.size() / 61 + 1) {
        for (const bool cut : {true, false}) {
            std::string text = cut ? whole.substr(0, at) : whole;
            if (!cut) text.replace(at, std::min<std::size_t>(200, text.size() - at), 200, '\xa5');
            std::ofstream(place / "case.db", std::ios::binary) << text;
            const auto read = readCase(place);  // never a crash; what is whole may still be read
            EXPECT_TRUE(read || read.error().sentence().find("case.") != std::string::npos) << at << cut;
        }
    }
    std::ofstream(place / "case.db", std::ios::binary) << std::string(5000, 'x');
    const auto read = readCase(place);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::input);
    EXPECT_THAT(read.error().sentence(), HasSubstr("case.json beside it"));
    fs::remove(place / "case.db");
    fs::create_symlink(folder / "nowhere", place / "case.db");
    EXPECT_FALSE(readCase(place)) << "links lead out of the case";
}

}  // namespace
}  // namespace vestige
