#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace vestige {

/// Walks through text by lines or by tokens and knows the line it is on. Lines end with LF or CR LF.
class TextScanner {
  public:
    explicit TextScanner(std::string_view text, std::size_t offset = 0, std::size_t line = 1)
        : text_(text), offset_(offset), line_(line) {}

    bool atEnd() const { return offset_ >= text_.size(); }
    std::size_t offset() const { return offset_; }
    /// Of the next character, from 1.
    std::size_t line() const { return line_; }

    /// The rest of the current line without its end; moves to the next line.
    std::string_view nextLine();
    /// The next run of characters that are no blanks, across lines; empty at the end of the text.
    std::string_view nextToken();
    /// Over `bytes` of something else than text; line() is of the text before it from then on.
    void skip(std::size_t bytes) { offset_ += bytes; }
    /// The next token as a number; nothing when it is none or the text ends.
    std::optional<double> nextNumber();

  private:
    std::string_view text_;
    std::size_t offset_ = 0;
    std::size_t line_ = 1;
};

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);
/// The first run of characters that are no blanks; `text` is moved behind it. Empty when there is none.
std::string_view takeToken(std::string_view& text);
/// `text` in ASCII lower case equals `lower`.
bool equalsIgnoringCase(std::string_view text, std::string_view lower);

/// A number at the beginning of [text, end): "1.5", "+3", "-2e5", "nan"; moves `text` behind it. Nothing, and
/// `text` stays, when there is none.
std::optional<double> takeNumber(const char*& text, const char* end);

}  // namespace vestige
