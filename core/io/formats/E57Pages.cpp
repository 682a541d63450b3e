#include "core/io/formats/E57Pages.h"

#include <algorithm>
#include <cstring>

#include "core/base/Parallel.h"
#include "core/io/Bytes.h"
#include "core/io/formats/Crc32c.h"

namespace vestige {
namespace {

constexpr std::size_t kHeader = 48;
constexpr std::size_t kChecksum = 4;
/// The standard knows pages of 1024 bytes alone; its header has a field for others.
constexpr std::uint64_t kSmallestPage = 64;
constexpr std::uint64_t kLargestPage = 1 << 20;

}  // namespace

E57Pages::E57Pages(std::span<const std::byte> file, bool salvage, ReadJob& job)
    : file_(file), salvage_(salvage) {
    if (file.size() < kHeader)
        job.refuseByte(file.size(), "the file ends inside its header", "a header of 48 bytes");
    if (std::memcmp(file.data(), "ASTM-E57", 8) != 0)
        job.refuseByte(0, "the file does not begin with 'ASTM-E57'", "the signature of an E57 file");
    const auto major = load<std::uint32_t>(file.data() + 8);
    const auto minor = load<std::uint32_t>(file.data() + 12);
    if (major != 1)
        job.refuseByte(8, "version " + std::to_string(major) + "." + std::to_string(minor) + " is unknown",
                       "E57 version 1");
    const auto length = load<std::uint64_t>(file.data() + 16);
    page_ = load<std::uint64_t>(file.data() + 40);
    if (page_ < kSmallestPage || page_ > kLargestPage || (page_ & (page_ - 1)) != 0)
        job.refuseByte(40, "the pages cannot be of " + std::to_string(page_) + " bytes", "1024");
    content_ = page_ - kChecksum;
    if (file.size() >= page_ && !whole(0)) refusePage(0, job);
    if (length > file.size() && !salvage)
        job.refuseByte(file.size(), "the file ends too early; its header promises " + counted(length, "byte"),
                       "a whole file");
    missing_ = length > file.size() ? length - file.size() : 0;
    if (length < file.size()) {
        job.warn(counted(file.size() - length, "byte") + " after the end of the file's content passed over");
        file_ = file.first(length);
    }
    pages_ = file_.size() / page_;
    if (pages_ == 0 || length % page_ != 0)
        job.refuseByte(16, "a length of " + counted(length, "byte") + " is no number of whole pages",
                       "a multiple of " + std::to_string(page_));
    xmlLength_ = load<std::uint64_t>(file.data() + 32);
    xmlOffset_ = logical(load<std::uint64_t>(file.data() + 24), "the XML section", 24, job);
    if (xmlLength_ > logicalSize() - xmlOffset_)
        job.refuseByte(32, "the XML section of " + counted(xmlLength_, "byte") + " reaches beyond the file",
                       "at most " + std::to_string(logicalSize() - xmlOffset_));
}

std::uint64_t E57Pages::logical(std::uint64_t physical, const std::string& what, std::size_t byte,
                                const ReadJob& job) const {
    if (physical < kHeader || physical >= pages_ * page_)
        job.refuseByte(
            byte, what + " is said to begin at byte " + std::to_string(physical) + ", outside of the file",
            "48 to " + std::to_string(pages_ * page_ - 1));
    if (physical % page_ >= content_)
        job.refuseByte(
            byte,
            what + " is said to begin at byte " + std::to_string(physical) + ", inside a page's checksum",
            "a byte of its content");
    return physical / page_ * content_ + physical % page_;
}

bool E57Pages::whole(std::uint64_t page) const {
    const std::byte* begin = file_.data() + page * page_;
    return crc32c({begin, content_}) == load<std::uint32_t>(begin + content_, std::endian::big);
}

void E57Pages::refusePage(std::uint64_t page, const ReadJob& job) const {
    job.refuseByte(page * page_, "the page has another checksum than it says: the file is damaged here",
                   "the CRC-32C of the page's content");
}

void E57Pages::checkAll(const ReadJob& job) {
    constexpr std::size_t kGrain = 4096;
    std::vector<std::vector<std::uint64_t>> found((pages_ + kGrain - 1) / kGrain);
    parallelChunks(pages_, kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t page = begin; page < end; ++page)
            if (!whole(page)) found[chunk].push_back(page);
    });
    for (const auto& pages : found) damaged_.insert(damaged_.end(), pages.begin(), pages.end());
    if (!salvage_ && !damaged_.empty()) refusePage(damaged_.front(), job);
}

std::string E57Pages::damage() const {
    std::string text;
    if (missing_ > 0) text = "the last " + counted(missing_, "byte") + " of the file are missing";
    if (!damaged_.empty())
        text += (text.empty() ? "" : "; ") + counted(damaged_.size(), "page") + " of " +
                std::to_string(pages_) + " " + (damaged_.size() == 1 ? "is" : "are") +
                " damaged, the first at byte " + std::to_string(damaged_.front() * page_);
    return text;
}

void E57Pages::check(std::uint64_t logical, std::uint64_t length, const ReadJob& job) const {
    if (length == 0) return;
    for (std::uint64_t page = logical / content_; page <= (logical + length - 1) / content_; ++page)
        if (!whole(page)) refusePage(page, job);
}

bool E57Pages::damaged(std::uint64_t logical, std::uint64_t length) const {
    if (damaged_.empty() || length == 0) return false;
    const auto first = std::lower_bound(damaged_.begin(), damaged_.end(), logical / content_);
    return first != damaged_.end() && *first <= (logical + length - 1) / content_;
}

void E57Pages::copy(std::uint64_t logical, std::span<std::byte> to) const {
    std::byte* at = to.data();
    for (std::size_t left = to.size(); left > 0;) {
        const std::uint64_t inPage = logical % content_;
        const std::size_t piece = std::min<std::uint64_t>(left, content_ - inPage);
        std::memcpy(at, file_.data() + logical / content_ * page_ + inPage, piece);
        at += piece;
        logical += piece;
        left -= piece;
    }
}

}  // namespace vestige
