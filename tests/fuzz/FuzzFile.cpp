#include "tests/fuzz/FuzzFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/Beside.h"

namespace vestige::fuzz {
namespace {

constexpr std::size_t kLongestSentence = 2000;

/// The length of the UTF-8 character at `at`, 0 where there is none (RFC 3629).
std::size_t utf8Length(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned first = byte(at);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xc2 && first <= 0xdf ? 2 : first >= 0xe0 && first <= 0xef ? 3 : 4;
    if (first < 0xc2 || first > 0xf4) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(at + i) & 0xc0) != 0x80) return 0;
    const unsigned second = byte(at + 1);
    if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
        (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
        return 0;
    return length;
}

}  // namespace

FuzzFile::FuzzFile(const std::string& name, const std::string& extension)
    : folder_("/dev/shm/vestige-fuzz-" + name + "-" + std::to_string(::getpid())),
      path_(folder_ / ("input." + extension)) {
    std::error_code problem;
    std::filesystem::create_directories(folder_, problem);
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    putBeside(extension, folder_);
    if (descriptor_ >= 0) return;
    std::perror(path_.c_str());
    std::exit(1);
}

FuzzFile::~FuzzFile() {
    ::close(descriptor_);
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

void FuzzFile::put(std::span<const std::uint8_t> bytes) const {
    const auto size = static_cast<ssize_t>(bytes.size());
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0 || status.st_nlink == 0) {
        std::fprintf(stderr, "%s was removed: nothing is tested any more\n", path_.c_str());
        std::exit(1);
    }
    if (::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, bytes.data(), bytes.size(), 0) == size)
        return;
    std::perror(path_.c_str());
    std::exit(1);
}

void finding(const std::string& what) {
    std::fprintf(stderr, "finding: %s\n", what.c_str());
    std::abort();
}

void checkSentence(const std::string& sentence) {
    if (sentence.empty() || sentence.size() > kLongestSentence)
        finding("a sentence of " + std::to_string(sentence.size()) + " bytes: " + sentence.substr(0, 300));
    for (std::size_t at = 0; at < sentence.size();) {
        const std::size_t length = utf8Length(sentence, at);
        const auto c = static_cast<unsigned char>(sentence[at]);
        if (length == 0 || c < ' ' || c == 0x7f) finding("a sentence that is no clean text: " + sentence);
        at += length;
    }
}

void checkError(const Error& error, const std::filesystem::path& file) {
    checkSentence(error.sentence());
    if (error.code != ErrorCode::input) finding("a wrong code: " + error.sentence());
    // The file itself, or one beside it that it names.
    const std::string place = (file.has_parent_path() ? file.parent_path() : file).string();
    if (error.message.empty() || error.place.find(place) == std::string::npos)
        finding("no file is named: " + error.sentence());
}

}  // namespace vestige::fuzz
