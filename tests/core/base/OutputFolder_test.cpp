#include "core/base/OutputFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include "core/base/AtomicFile.h"
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
