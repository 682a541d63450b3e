// A case's database from anybody: the input is case.db in a case's folder.
#include <filesystem>

#include "core/scene/CaseFile.h"
#include "tests/fuzz/FuzzFile.h"
#include "tests/fuzz/MemoryBound.h"

namespace {

// SQLite keeps 2 MB of pages; the texts in them are JSON trees for a moment.
constexpr std::size_t kFixed = std::size_t{8} << 20;
constexpr std::size_t kPerByte = 400;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    vestige::fuzz::MemoryBound::install();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    namespace fs = std::filesystem;
    static const vestige::fuzz::FuzzFile file(VESTIGE_FUZZ_NAME, "db");
    static const fs::path folder = file.path().parent_path() / "night.vestige";
    file.put({data, size});
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    fs::create_directory(folder, ignored);
    fs::copy_file(file.path(), folder / "case.db", ignored);
    const vestige::fuzz::MemoryBound bound(size, kFixed, kPerByte);
    std::vector<std::string> notes;
    const auto read = vestige::readCase(folder, &notes);
    if (!read) vestige::fuzz::checkError(read.error(), folder);
    for (const std::string& note : notes) vestige::fuzz::checkSentence(note);
    return 0;
}
