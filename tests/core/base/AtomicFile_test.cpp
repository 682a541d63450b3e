#include "core/base/AtomicFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

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

TEST(AtomicFile, SeveralStandAllOrNone) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "a.txt", "old"));
    {
        AtomicFile a(folder / "a.txt"), b(folder / "b.txt"), c(folder / "c.txt");
        for (AtomicFile* file : {&a, &b, &c}) {
            ASSERT_TRUE(file->open());
            file->write("new");
        }
        std::filesystem::create_directory(folder / "c.txt");  // comes in the way after open()
        const Status done = AtomicFile::commit({&a, &b, &c});
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().code, ErrorCode::output);
    }
    EXPECT_EQ(readTextFile(folder / "a.txt").value(), "old");
    EXPECT_FALSE(std::filesystem::exists(folder / "b.txt"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2) << "a.txt, c.txt";
    {
        AtomicFile a(folder / "a.txt"), b(folder / "b.txt");
        for (AtomicFile* file : {&a, &b}) {
            ASSERT_TRUE(file->open());
            file->write("new");
        }
        ASSERT_TRUE(AtomicFile::commit({&a, &b}));
    }
    EXPECT_EQ(readTextFile(folder / "a.txt").value(), "new");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
}

TEST(AtomicFile, WritesIntoADeviceAndLeavesIt) {
    ASSERT_TRUE(writeTextFile("/dev/null", "nothing"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, SaysWhenAPlaceCannotBeLookedAt) {
    const test::TemporaryFolder folder;
    std::filesystem::create_symlink("loop", folder / "loop");
    const Status done = writeTextFile(folder / "loop/file", "");
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::output);
}

TEST(AtomicFile, KnowsTheSamePlaceByOtherNames) {
    EXPECT_TRUE(samePlace("a.csv", "./x/../a.csv"));
    EXPECT_FALSE(samePlace("a.csv", "b.csv"));
    EXPECT_FALSE(samePlace("", ""));
}

TEST(AtomicFile, ReplacesALinkAndLeavesWhatItLeadsTo) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "evidence.csv", "1 2 3"));
    std::filesystem::create_symlink(folder / "evidence.csv", folder / "out.csv");
    std::filesystem::create_symlink(folder / "nowhere", folder / "broken.csv");
    ASSERT_TRUE(writeTextFile(folder / "out.csv", "new"));
    ASSERT_TRUE(writeTextFile(folder / "broken.csv", "new"));
    EXPECT_EQ(readTextFile(folder / "evidence.csv").value(), "1 2 3");
    for (const char* name : {"out.csv", "broken.csv"}) {
        EXPECT_FALSE(std::filesystem::is_symlink(folder / name));
        EXPECT_EQ(readTextFile(folder / name).value(), "new");
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "nowhere"));
}

TEST(AtomicFile, DoesNotWriteThroughALinkThatWaitsUnderItsTemporaryName) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "evidence.csv", "1 2 3"));
    AtomicFile file(folder / "out.csv");
    std::filesystem::create_symlink(folder / "evidence.csv", file.temporaryPath());
    ASSERT_TRUE(file.open());
    file.write("new");
    ASSERT_TRUE(file.commit());
    EXPECT_EQ(readTextFile(folder / "evidence.csv").value(), "1 2 3");
    EXPECT_EQ(readTextFile(folder / "out.csv").value(), "new");
}

TEST(AtomicFile, APlaceUnderDevIsWrittenToAndNotReplaced) {
    // What /dev/stdout leads to may be a file; the name must stay the link that it is.
    const AtomicFile standardOutput("/dev/stdout");
    EXPECT_EQ(standardOutput.temporaryPath(), "/dev/stdout");
}

TEST(AtomicFile, ReadingAPipeIsRefusedAndDoesNotWait) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const auto text = readTextFile(folder / "pipe");
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().message, "this is a device or pipe, a file was expected");
}
