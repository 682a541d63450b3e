#include "core/base/OutputFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <random>

#include "core/base/AtomicFile.h"
#include "core/base/Leftovers.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::ElementsAre;

/// Names of everything below a folder, hidden entries too.
std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            names.push_back(entry.path().lexically_relative(folder).generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(OutputFolder, AppearsWholeOnCommitAndLeavesNothingBeside) {
    const TemporaryFolder folder;
    {
        OutputFolder output(folder / "out");
        ASSERT_TRUE(output.open());
        ASSERT_TRUE(writeTextFile(output.path("b.csv"), "b"));
        ASSERT_TRUE(writeTextFile(output.path("pictures/a.png"), "a"));
        EXPECT_FALSE(fs::exists(folder / "out")) << "nothing is to be seen before the end";
        EXPECT_THAT(output.files(), ElementsAre("b.csv", "pictures/a.png"));
        ASSERT_TRUE(output.commit());
    }
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("out/b.csv", "out/pictures/a.png"));
}

TEST(OutputFolder, LeavesEarlierResultsUntouchedWithoutCommit) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "out/b.csv", "old"));
    {
        OutputFolder output(folder / "out/");
        ASSERT_TRUE(output.open());
        ASSERT_TRUE(writeTextFile(output.path("b.csv"), "new"));
    }
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("out/b.csv"));
    EXPECT_EQ(readTextFile(folder / "out/b.csv").value(), "old");
}

TEST(OutputFolder, ReplacesItsFilesAndRemovesObsoleteOnesButKeepsStrangers) {
    const TemporaryFolder folder;
    for (const char* name : {"out/b.csv", "out/pictures/gone.png", "out/mine.txt"})
        ASSERT_TRUE(writeTextFile(folder / name, "old"));
    {
        OutputFolder output(folder / "out");
        ASSERT_TRUE(output.open());
        ASSERT_TRUE(writeTextFile(output.path("b.csv"), "new"));
        ASSERT_TRUE(output.commit({"pictures/gone.png", "never/was.png"}));
    }
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("out/b.csv", "out/mine.txt"));
    EXPECT_EQ(readTextFile(folder / "out/b.csv").value(), "new");
}

TEST(OutputFolder, PutsEverythingBackWhenAFileCannotBeMoved) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "out/a.csv", "old"));
    fs::create_directories(folder / "out/b.csv");  // a folder stands where a file must go
    {
        OutputFolder output(folder / "out");
        ASSERT_TRUE(output.open());
        ASSERT_TRUE(writeTextFile(output.path("a.csv"), "new"));
        ASSERT_TRUE(writeTextFile(output.path("b.csv"), "new"));
        const Status done = output.commit();
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().code, ErrorCode::output);
        EXPECT_NE(done.error().place.find("b.csv"), std::string::npos);
    }
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("out/a.csv"));
    EXPECT_EQ(readTextFile(folder / "out/a.csv").value(), "old");
}

TEST(OutputFolder, PutsEverythingBackWhenAFolderCannotBeLookedInto) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "out/a.csv", "old"));
    ASSERT_TRUE(writeTextFile(folder / "out/gone.csv", "old"));
    fs::create_symlink("pictures", folder / "out/pictures");  // a link to itself
    {
        OutputFolder output(folder / "out");
        ASSERT_TRUE(output.open());
        ASSERT_TRUE(writeTextFile(output.path("a.csv"), "new"));
        ASSERT_TRUE(writeTextFile(output.path("pictures/top.png"), "new"));
        const Status done = output.commit({"gone.csv"});
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().code, ErrorCode::output);
    }
    EXPECT_EQ(readTextFile(folder / "out/a.csv").value(), "old");
    EXPECT_EQ(readTextFile(folder / "out/gone.csv").value(), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing is left beside";
}

TEST(OutputFolder, IsExchangedInOneStepWhereItHoldsOnlyKnownFiles) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "out/b.csv", "old"));
    ASSERT_TRUE(writeTextFile(folder / "out/pictures/gone.png", "old"));
    fs::permissions(folder / "out", fs::perms::owner_all);
    struct stat before {
    }, after{};
    ASSERT_EQ(::stat((folder / "out").c_str(), &before), 0);
    {
        OutputFolder output(folder / "out");
        ASSERT_TRUE(output.open());
        ASSERT_TRUE(writeTextFile(output.path("b.csv"), "new"));
        ASSERT_TRUE(output.commit({"pictures/gone.png"}));
    }
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("out/b.csv"));
    EXPECT_EQ(readTextFile(folder / "out/b.csv").value(), "new");
    ASSERT_EQ(::stat((folder / "out").c_str(), &after), 0);
    EXPECT_NE(before.st_ino, after.st_ino) << "another folder took its name";
    EXPECT_EQ(before.st_mode, after.st_mode);
}

/// Kills a child that commits, `after` so many microseconds; true when it had not ended by itself.
bool killedWhileCommitting(const fs::path& place, const std::string& text, long after_us) {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        OutputFolder output(place);
        if (!output.open()) ::_exit(3);
        for (const char* name : {"a.csv", "b.csv", "c/d.png", "c/e.png", "manifest.json"})
            if (!writeTextFile(output.path(name), text)) ::_exit(3);
        if (::write(ready[1], "x", 1) != 1) ::_exit(3);
        ::_exit(output.commit() ? 0 : 3);
    }
    char begun = 0;
    EXPECT_EQ(::read(ready[0], &begun, 1), 1);
    ::usleep(static_cast<useconds_t>(after_us));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    return WIFSIGNALED(status);
}

/// How long it takes where nobody kills it.
long commitTime_us(const fs::path& place) {
    const auto begin = std::chrono::steady_clock::now();
    {
        OutputFolder output(place);
        EXPECT_TRUE(output.open());
        for (const char* name : {"a.csv", "b.csv", "c/d.png", "c/e.png", "manifest.json"})
            std::ofstream(output.path(name)) << "first";
        EXPECT_TRUE(output.commit());
    }
    return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin)
        .count();
}

/// The one text that all outputs hold; nothing when they differ or one is missing.
std::optional<std::string> oneTextOf(const fs::path& place) {
    std::optional<std::string> common;
    for (const char* name : {"a.csv", "b.csv", "c/d.png", "c/e.png", "manifest.json"}) {
        const auto text = readTextFile(place / name);
        if (!text || (common && *common != *text)) return std::nullopt;
        common = *text;
    }
    return common;
}

TEST(OutputFolder, KilledWhileItIsPutInPlaceItIsTheOldOrTheNew) {
    const TemporaryFolder folder;
    std::mt19937 random(7);
    const long whole_us = commitTime_us(folder / "out");
    int killed = 0;
    for (int round = 0; round < 40; ++round) {
        killed += killedWhileCommitting(folder / "out", "round " + std::to_string(round),
                                        static_cast<long>(random()) % whole_us);
        if (!fs::exists(folder / "out")) continue;
        EXPECT_TRUE(oneTextOf(folder / "out")) << "after round " << round;
    }
    EXPECT_GT(killed, 0);
    OutputFolder next(folder / "out");
    ASSERT_TRUE(next.open());
    ASSERT_TRUE(writeTextFile(next.path("manifest.json"), "m"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2) << "the killed ones left nothing";
}

TEST(OutputFolder, KilledBetweenStrangersItIsFinishedByTheNext) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "out/mine.txt", "mine"));
    std::mt19937 random(11);
    const long whole_us = commitTime_us(folder / "out");
    for (int round = 0; round < 40; ++round) {
        killedWhileCommitting(folder / "out", "round " + std::to_string(round),
                              static_cast<long>(random()) % whole_us);
        EXPECT_TRUE(oneTextOf(folder / "out") || !fs::exists(folder / "out/manifest.json"))
            << "a mixture has no manifest";
        OutputFolder next(folder / "out");
        ASSERT_TRUE(next.open());
        EXPECT_TRUE(oneTextOf(folder / "out") || !fs::exists(folder / "out/a.csv")) << round;
        EXPECT_EQ(readTextFile(folder / "out/mine.txt").value(), "mine");
    }
}

TEST(AtomicFile, ClearsAwayWhatAKilledProcessLeft) {
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        AtomicFile file(folder / "table.csv");
        if (!file.open()) ::_exit(3);
        file.write("half");
        file.stream().flush();
        ::raise(SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(namesIn(folder.path()).size(), 1u);
    EXPECT_FALSE(fs::exists(folder / "table.csv"));
    ASSERT_TRUE(
        writeTextFile(folder / ".table.partial-1-beef.csv", "of a living process of another machine"));
    ASSERT_TRUE(writeTextFile(folder / "table.csv", "whole"));
    EXPECT_THAT(namesIn(folder.path()), ElementsAre(".table.partial-1-beef.csv", "table.csv"));
}

TEST(AtomicFile, AgeCountsOnlyForProcessesOfOtherMachines) {
    const TemporaryFolder folder;
    const auto lastWeek = fs::file_time_type::clock::now() - std::chrono::hours(24 * 7);
    const std::string mine = ".table.replaced-" + ownerMark() + ".csv";
    for (const std::string& name : {mine, std::string(".table.partial-1-beef.csv")}) {
        ASSERT_TRUE(writeTextFile(folder / name, "old"));
        fs::last_write_time(folder / name, lastWeek);
    }
    OutputFolder living(folder / "out");
    ASSERT_TRUE(living.open());
    ASSERT_TRUE(writeTextFile(living.path("a.csv"), "a"));
    for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.is_directory()) fs::last_write_time(entry.path(), lastWeek);
    const pid_t other = ::fork();
    if (other == 0) {
        OutputFolder second(folder / "out");
        ::_exit(second.open() && writeTextFile(folder / "table.csv", "new") ? 0 : 3);
    }
    int status = 0;
    ::waitpid(other, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(fs::exists(folder / mine)) << "its process lives";
    EXPECT_FALSE(fs::exists(folder / ".table.partial-1-beef.csv"));
    ASSERT_TRUE(living.commit());
    EXPECT_EQ(readTextFile(folder / "out/a.csv").value_or("lost"), "a");
}

TEST(OutputFolder, RefusesAPlaceThatIsAFile) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "out", "a file"));
    OutputFolder output(folder / "out");
    const Status opened = output.open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::output);
}

}  // namespace
}  // namespace vestige
