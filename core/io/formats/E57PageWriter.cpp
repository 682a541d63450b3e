#include "core/io/formats/E57PageWriter.h"

#include <algorithm>
#include <bit>

#include "core/io/Bytes.h"
#include "core/io/formats/Crc32c.h"

namespace vestige {

void E57PageWriter::add(std::span<const std::byte> content) {
    while (!content.empty()) {
        const std::size_t piece = std::min<std::size_t>(content.size(), kContent - page_.size());
        page_.insert(page_.end(), content.begin(), content.begin() + static_cast<std::ptrdiff_t>(piece));
        content = content.subspan(piece);
        if (page_.size() == kContent) emitPage();
    }
}

void E57PageWriter::finish() {
    if (page_.empty()) return;
    page_.resize(kContent);
    emitPage();
}

void E57PageWriter::emitPage() {
    const std::uint32_t sum = crc32c(page_);
    for (int shift = 24; shift >= 0; shift -= 8) page_.push_back(static_cast<std::byte>(sum >> shift & 0xff));
    file_.write(page_);
    page_.clear();
}

}  // namespace vestige
