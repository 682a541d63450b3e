#include "core/scene/store/SideFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/AtomicFile.h"
#include "core/scene/CaseFile.h"
#include "core/scene/store/CaseSession.h"
#include "core/scene/store/CaseStore.h"
#include "core/scene/store/Database.h"
#include "tests/core/scene/SampleScene.h"
#include "tests/support/TestPaths.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

void append(std::string& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xff);
}

/// A journal without pages whose end names a super-journal (layout: sqlite.org/fileformat2.html).
std::string journalNaming(const fs::path& victim, std::uint64_t databaseBytes) {
    constexpr std::uint32_t kPage = 4096, kSector = 512;
    const std::string magic = "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";
    const std::string name = victim.string();
    std::string bytes = magic;
    for (const auto number : {0U, 1234U, static_cast<std::uint32_t>(databaseBytes / kPage), kSector, kPage})
        append(bytes, number);
    bytes.resize(kSector, '\0');
    append(bytes, 0x40000000 / kPage + 1);
    std::uint32_t sum = 0;
    for (const char letter : name) sum += static_cast<std::uint32_t>(static_cast<signed char>(letter));
    bytes += name;
    append(bytes, static_cast<std::uint32_t>(name.size()));
    append(bytes, sum);
    return bytes + magic;
}

class SideFiles : public testing::Test {
  public:
    SideFiles() {
        EXPECT_TRUE(writeCase(place, test::sampleScene()));
        EXPECT_TRUE(writeTextFile(evidence, "evidence, evidence"));
    }
    /// Reading a copy is harmless; what opens the case itself must not.
    void expectRefusedAndEvidenceWhole(const char* what) const {
        const auto read = readCase(place);
        if (!read) {
            EXPECT_THAT(read.error().sentence(), HasSubstr(what));
        }
        const auto store = CaseStore::open(place);
        ASSERT_FALSE(store);
        EXPECT_THAT(store.error().sentence(), HasSubstr(what));
        EXPECT_FALSE(writeCase(place, test::sampleScene()));
        static_cast<void>(CaseSession(Autosaves(folder / "user"), place));
        EXPECT_EQ(readTextFile(evidence).value_or("gone"), "evidence, evidence");
    }

    TemporaryFolder folder;
    fs::path place = folder / "night.vestige";
    fs::path evidence = folder / "evidence.las";
};

TEST_F(SideFiles, AJournalThatNamesAnotherFileDoesNotDeleteIt) {
    ASSERT_TRUE(
        writeTextFile(place / "case.db-journal", journalNaming(evidence, fs::file_size(place / "case.db"))));
    expectRefusedAndEvidenceWhole("this journal names another file");
    const auto read = readCase(place);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::input);
}

TEST_F(SideFiles, LinksAreNotWrittenThrough) {
    for (const char* name : {"case.db-journal", "case.db-wal", "case.db-shm"})
        for (const bool hard : {false, true}) {
            SCOPED_TRACE(name);
            if (hard)
                fs::create_hard_link(evidence, place / name);
            else
                fs::create_symlink(evidence, place / name);
            expectRefusedAndEvidenceWhole("this is a link or a pipe");
            fs::remove(place / name);
        }
    EXPECT_TRUE(readCase(place));
}

TEST_F(SideFiles, ALockThatIsAnotherNameOfEvidenceIsNotWrittenTo) {
    fs::create_hard_link(evidence, place / "lock");
    static_cast<void>(writeCase(place, test::sampleScene()));
    EXPECT_EQ(readTextFile(evidence).value_or("gone"), "evidence, evidence");
}

TEST_F(SideFiles, AJournalOfOnesOwnIsPlayedBack) {
    // What a killed window leaves: a journal whose last pages may end anywhere.
    std::string journal = journalNaming("x", fs::file_size(place / "case.db"));
    journal.resize(512);
    ASSERT_TRUE(writeTextFile(place / "case.db-journal", journal));
    const auto read = readCase(place);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_FALSE(fs::exists(place / "case.db-journal"));
}

}  // namespace
}  // namespace vestige
