// E57 pages end with checksums that a changed byte nearly always breaks. So most inputs are changed without
// them, and get right ones, and mostly a header that fits, afterwards; the others are changed as they lie.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/io/Bytes.h"
#include "core/io/formats/Crc32c.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

constexpr std::size_t kPage = 1024;
constexpr std::size_t kContent = 1020;
constexpr std::size_t kHeader = 48;
// Places in the header: the file's length, the XML's place and length, the size of a page.
constexpr std::size_t kLength = 16, kXml = 24, kXmlLength = 32, kPageSize = 40;

void fitHeader(std::vector<std::uint8_t>& content, std::size_t used) {
    auto* head = reinterpret_cast<std::byte*>(content.data());
    vestige::store<std::uint64_t>(head + kLength, content.size() / kContent * kPage);
    vestige::store<std::uint64_t>(head + kPageSize, kPage);
    const std::string_view text(reinterpret_cast<const char*>(content.data()), used);
    const std::size_t begin = text.rfind("<?xml"), end = text.rfind('>');
    if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) return;
    vestige::store<std::uint64_t>(head + kXml, begin / kContent * kPage + begin % kContent);
    vestige::store<std::uint64_t>(head + kXmlLength, end + 1 - begin);
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    if (size < kPage || most < kPage || seed % 8 == 0) return LLVMFuzzerMutate(data, size, most);
    std::vector<std::uint8_t> content;
    for (std::size_t at = 0; at < size; at += kPage)
        content.insert(content.end(), data + at, data + std::min(size, at + kContent));
    std::size_t used = std::min(content.size(), most / kPage * kContent);
    content.resize(most / kPage * kContent);
    used = LLVMFuzzerMutate(content.data(), used, content.size());
    std::fill(content.begin() + static_cast<std::ptrdiff_t>(used), content.end(), std::uint8_t{0});
    content.resize(std::max<std::size_t>(1, (used + kContent - 1) / kContent) * kContent);
    if (used >= kHeader && seed % 8 != 1) fitHeader(content, used);
    std::size_t out = 0;
    for (std::size_t at = 0; at < content.size(); at += kContent, out += kPage) {
        std::copy_n(content.data() + at, kContent, data + out);
        const std::uint32_t sum = vestige::crc32c(std::as_bytes(std::span(content).subspan(at, kContent)));
        for (std::size_t i = 0; i < 4; ++i)
            data[out + kContent + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    }
    return out;
}
