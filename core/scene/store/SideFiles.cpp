#include "core/scene/store/SideFiles.h"

#include <sys/stat.h>

#include <array>
#include <fstream>
#include <string_view>

#include "core/base/Result.h"

namespace vestige {
namespace {

using namespace std::string_view_literals;

/// Begins each header of a journal and ends the name of a super-journal (https://sqlite.org/fileformat2.html,
/// "The Rollback Journal"; the name is described with pager.c's readSuperJournal).
constexpr std::string_view kJournalMagic = "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7"sv;

[[noreturn]] void refuse(const std::filesystem::path& file, const char* what) {
    throw ErrorException{
        {ErrorCode::input, what, file.string(),
         "no case of Vestige has it: it was put there to harm; case.json beside it is readable"}};
}

bool namesAnotherFile(const std::filesystem::path& journal) {
    std::ifstream stream(journal, std::ios::binary);
    std::array<char, kJournalMagic.size()> end{};
    stream.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
    // Alone, at the beginning of a header, it names nothing.
    const auto at = stream.tellg();
    return stream.read(end.data(), end.size()) && at > 0 &&
           std::string_view(end.data(), end.size()) == kJournalMagic;
}

}  // namespace

void checkSideFiles(const std::filesystem::path& database) {
    for (const char* suffix : {"-journal", "-wal", "-shm"}) {
        std::filesystem::path file = database;
        file += suffix;
        struct stat status {};
        if (::lstat(file.c_str(), &status) != 0) continue;
        if (!S_ISREG(status.st_mode) || status.st_nlink != 1)
            refuse(file, "this is a link or a pipe where a case's database keeps a file of its own");
    }
    std::filesystem::path journal = database;
    journal += "-journal";
    if (namesAnotherFile(journal)) refuse(journal, "this journal names another file, which would be deleted");
}

}  // namespace vestige
