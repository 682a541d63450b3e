// One target per function that reads a file into a Result; CMake names function, header and extension.
#include VESTIGE_FUZZ_HEADER

#include "tests/fuzz/FuzzFile.h"
#include "tests/fuzz/MemoryBound.h"

namespace {

// JSON trees and lists of text cells take some 50 bytes for each two of the file.
constexpr std::size_t kFixed = std::size_t{4} << 20;
constexpr std::size_t kPerByte = 200;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    vestige::fuzz::MemoryBound::install();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const vestige::fuzz::FuzzFile file(VESTIGE_FUZZ_NAME, VESTIGE_FUZZ_EXTENSION);
    file.put({data, size});
    const vestige::fuzz::MemoryBound bound(size, kFixed, kPerByte);
    const auto read = vestige::VESTIGE_FUZZ_FUNCTION(file.path());
    if (!read) vestige::fuzz::checkError(read.error(), file.path());
    return 0;
}
