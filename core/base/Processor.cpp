#include "core/base/Processor.h"

#include <cpuid.h>

#include <array>
#include <cstring>

namespace vestige {

std::string processorName() {
    // CPUID leaves 0x80000002 to 0x80000004 hold 48 bytes of text.
    constexpr unsigned kFirst = 0x80000002;
    std::array<unsigned, 4> words{};
    std::string name;
    for (unsigned leaf = kFirst; leaf < kFirst + 3; ++leaf) {
        if (!__get_cpuid(leaf, &words[0], &words[1], &words[2], &words[3])) return {};
        std::array<char, sizeof words + 1> text{};
        std::memcpy(text.data(), words.data(), sizeof words);
        name += text.data();
    }
    const std::size_t begin = name.find_first_not_of(' ');
    if (begin == std::string::npos) return {};
    return name.substr(begin, name.find_last_not_of(' ') - begin + 1);
}

}  // namespace vestige
