#include "core/io/TextScanner.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace vestige {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

}  // namespace

std::string_view TextScanner::nextLine() {
    const std::size_t end = std::min(text_.find('\n', offset_), text_.size());
    std::string_view found = text_.substr(offset_, end - offset_);
    offset_ = std::min(end + 1, text_.size());
    ++line_;
    if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
    return found;
}

std::string_view TextScanner::nextToken() {
    while (offset_ < text_.size() && isBlank(text_[offset_])) {
        if (text_[offset_] == '\n') ++line_;
        ++offset_;
    }
    const std::size_t begin = offset_;
    while (offset_ < text_.size() && !isBlank(text_[offset_])) ++offset_;
    return text_.substr(begin, offset_ - begin);
}

std::optional<double> TextScanner::nextNumber() {
    const std::string_view token = nextToken();
    const char* at = token.data();
    const auto number = takeNumber(at, token.data() + token.size());
    if (at != token.data() + token.size()) return std::nullopt;
    return number;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view takeToken(std::string_view& text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    std::size_t length = 0;
    while (length < text.size() && !isBlank(text[length])) ++length;
    const std::string_view token = text.substr(0, length);
    text.remove_prefix(length);
    return token;
}

bool equalsIgnoringCase(std::string_view text, std::string_view lower) {
    return std::equal(text.begin(), text.end(), lower.begin(), lower.end(), [](char a, char b) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(a))) == b;
    });
}

std::optional<double> takeNumber(const char*& text, const char* end) {
    const char* begin = text;
    if (begin != end && *begin == '+' && begin + 1 != end && begin[1] != '-') ++begin;
    double value = 0;
    const auto [stop, problem] = std::from_chars(begin, end, value);
    if (problem == std::errc::invalid_argument) return std::nullopt;
    if (problem == std::errc::result_out_of_range) {
        // Too large a number has no value here; too small a one is zero for every purpose.
        const std::string_view written(begin, static_cast<std::size_t>(stop - begin));
        if (written.find("e-") == std::string_view::npos && written.find("E-") == std::string_view::npos)
            return std::nullopt;
        value = 0;
    }
    text = stop;
    return value;
}

}  // namespace vestige
