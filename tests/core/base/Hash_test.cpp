#include "core/base/Hash.h"

#include <gtest/gtest.h>

#include "core/base/AtomicFile.h"
#include "tests/support/TestPaths.h"

using namespace vestige;

// The examples of FIPS 180-4.
TEST(Sha256, AgreesWithThePublishedExamples) {
    Sha256 empty;
    EXPECT_EQ(empty.hex(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    Sha256 abc;
    abc.add(std::string("a"));
    abc.add(std::string("bc"));
    EXPECT_EQ(abc.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, OfAFileAndOfAMissingOne) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "abc", "abc"));
    EXPECT_EQ(sha256OfFile(folder / "abc").value(),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256OfFile(folder / "none").error().code, ErrorCode::input);
}
