#include "core/base/AtomicFile.h"

#include <gtest/gtest.h>

#include "tests/support/TestPaths.h"

using namespace vestige;

TEST(AtomicFile, AppearsOnlyWithCommit) {
    const test::TemporaryFolder folder;
    const auto place = folder / "deep/a.txt";
    {
        AtomicFile file(place);
        ASSERT_TRUE(file.open());
        file.write("half");
        EXPECT_FALSE(std::filesystem::exists(place));
    }
    EXPECT_TRUE(std::filesystem::is_empty(place.parent_path()));
    ASSERT_TRUE(writeTextFile(place, "old"));
    {
        AtomicFile file(place);
        ASSERT_TRUE(file.open());
        file.write("new");
    }
    EXPECT_EQ(readTextFile(place).value(), "old");
}

TEST(AtomicFile, SaysWhenItCannotWrite) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "file", ""));
    EXPECT_EQ(writeTextFile(folder / "file/below", "").error().code, ErrorCode::output);
    EXPECT_EQ(writeTextFile(folder.path(), "").error().code, ErrorCode::output);
}
