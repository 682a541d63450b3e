#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <thread>

#include "core/base/AtomicFile.h"
#include "core/io/FormatRegistry.h"
#include "core/io/MappedFile.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// Stops counting when told to, and does something else to the file that is being read.
class OnProgress {
  public:
    explicit OnProgress(std::function<void()> action)
        : control(
              [this, action = std::move(action)](double, std::string_view) {
                  if (!done_.exchange(true)) action();
              },
              [](std::string_view) {}) {}

  private:
    std::atomic<bool> done_{false};

  public:
    JobControl control;
};

std::string manyLines(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += std::to_string(i % 97) + " " + std::to_string(i % 89) + " 1.5\n";
    return text;
}

TEST(MappedFile, WhatIsCutOffReadsAsZerosAndIsKnown) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "a.bin", std::string(1 << 20, 'x')));
    const std::size_t brokenBefore = MappedFile::brokenReads();
    {
        const auto whole = MappedFile::open(folder / "a.bin");
        const auto other = MappedFile::open(folder / "a.bin");
        ASSERT_TRUE(whole && other);
        EXPECT_EQ(whole->text().back(), 'x');
        fs::resize_file(folder / "a.bin", 10000);
        EXPECT_EQ(whole->text()[9999], 'x') << "what is still there is read";
        EXPECT_TRUE(whole->intact());
        EXPECT_EQ(whole->text()[500000], '\0');
        EXPECT_EQ(whole->text().back(), '\0');
        EXPECT_FALSE(whole->intact());
        EXPECT_TRUE(other->intact()) << "each mapping for itself";
    }
    EXPECT_EQ(MappedFile::brokenReads(), brokenBefore + 1);
}

TEST(MappedFile, ManyThreadsMeetTheEndOfTheSameFile) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "a.bin", std::string(8 << 20, 'x')));
    for (int round = 0; round < 20; ++round) {
        ASSERT_TRUE(writeTextFile(folder / "a.bin", std::string(8 << 20, 'x')));
        const auto file = MappedFile::open(folder / "a.bin");
        ASSERT_TRUE(file);
        std::atomic<std::size_t> sum{0};
        std::vector<std::thread> readers;
        for (int t = 0; t < 4; ++t)
            readers.emplace_back([&, t] {
                std::size_t mine = 0;
                for (std::size_t i = static_cast<std::size_t>(t); i < file->text().size(); i += 4)
                    mine += file->text()[i] == 'x';
                sum += mine;
            });
        fs::resize_file(folder / "a.bin", 4096 * 3);
        for (auto& reader : readers) reader.join();
        EXPECT_EQ(sum < std::size_t{8} << 20, !file->intact());
    }
}

TEST(MappedFileDeathTest, FaultsOfOthersStillEndTheProgram) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "a.bin", std::string(8192, 'x')));
    EXPECT_EXIT(
        {
            const auto ours = MappedFile::open(folder / "a.bin");
            std::FILE* file = std::fopen((folder / "a.bin").c_str(), "r+");
            auto* theirs =
                static_cast<volatile char*>(::mmap(nullptr, 8192, PROT_READ, MAP_SHARED, ::fileno(file), 0));
            fs::resize_file(folder / "a.bin", 0);
            static_cast<void>(theirs[5000]);
        },
        testing::KilledBySignal(SIGBUS), "");
}

TEST(ChangedFile, ThatShrinksWhileItIsReadIsRefusedWithASentence) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "cloud.xyz";
    ASSERT_TRUE(writeTextFile(file, manyLines(400000)));
    OnProgress shrinking([&] { fs::resize_file(file, 5000); });
    const auto loaded = readGeometry(file, shrinking.control);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    EXPECT_NE(loaded.error().sentence().find("changed while it was being read"), std::string::npos)
        << loaded.error().sentence();
    EXPECT_NE(loaded.error().sentence().find("cloud.xyz"), std::string::npos);
}

TEST(ChangedFile, AFaultInAnotherFileThatIsReadBesideItIsNoneOfItsOwn) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeTextFile(folder / "cloud.xyz", manyLines(100000)));
    ASSERT_TRUE(writeTextFile(folder / "other.bin", std::string(1 << 20, 'x')));
    bool broken = false;
    OnProgress beside([&] {
        std::thread([&] {
            const auto other = MappedFile::open(folder / "other.bin");
            fs::resize_file(folder / "other.bin", 10);
            broken = other->text().back() == '\0' && !other->intact();
        }).join();
    });
    const auto loaded = readGeometry(folder / "cloud.xyz", beside.control);
    EXPECT_TRUE(broken);
    ASSERT_TRUE(loaded) << loaded.error().sentence();
    EXPECT_EQ(loaded->geometry.vertices.size(), 100000U);
}

TEST(ChangedFile, ThatIsReplacedOrGrowsWhileItIsReadIsRefused) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "cloud.xyz";
    for (const bool replace : {true, false}) {
        ASSERT_TRUE(writeTextFile(file, manyLines(400000)));
        OnProgress changing([&] {
            if (replace)
                ASSERT_TRUE(writeTextFile(file, manyLines(400000)));
            else
                std::ofstream(file, std::ios::app) << "1 2 3\n";
        });
        const auto loaded = readGeometry(file, changing.control);
        ASSERT_FALSE(loaded) << replace;
        EXPECT_NE(loaded.error().sentence().find("changed while it was being read"), std::string::npos);
    }
    EXPECT_TRUE(readGeometry(file)) << "once it is still it is read";
}

}  // namespace
}  // namespace vestige
