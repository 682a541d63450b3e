#include "core/base/TextTemplate.h"

namespace vestige {
namespace {

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// From piece `next` on, which stands behind `at` or later; backtracks.
bool matchFrom(const TextTemplate& form, std::string_view text, std::size_t next, std::size_t at,
               std::vector<std::string_view>& values) {
    const std::string_view piece = form.pieces[next];
    if (next + 1 == form.pieces.size()) {
        if (text.size() < at + piece.size() || !text.ends_with(piece)) return false;
        values.push_back(text.substr(at, text.size() - piece.size() - at));
        return true;
    }
    for (std::size_t found = text.find(piece, at); found != std::string_view::npos;
         found = text.find(piece, found + 1)) {
        values.push_back(text.substr(at, found - at));
        if (matchFrom(form, text, next + 1, found + piece.size(), values)) return true;
        values.pop_back();
        if (piece.empty()) break;
    }
    return false;
}

}  // namespace

TextTemplate::TextTemplate(std::string_view text) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != '%' || text[i + 1] < '1' || text[i + 1] > '9') continue;
        pieces.push_back(text.substr(begin, i - begin));
        places.push_back(text[i + 1] - '0');
        begin = i + 2;
        ++i;
    }
    pieces.push_back(text.substr(begin));
}

std::size_t TextTemplate::literalSize() const {
    std::size_t size = 0;
    for (const std::string_view piece : pieces) size += piece.size();
    return size;
}

int TextTemplate::words() const {
    int count = 0;
    for (const std::string_view piece : pieces) {
        int letters = 0;
        for (const char c : piece) {
            letters = isLetter(c) ? letters + 1 : 0;
            if (letters == 2) ++count;
        }
    }
    return count;
}

std::optional<std::vector<std::string_view>> TextTemplate::match(std::string_view text) const {
    if (!text.starts_with(pieces.front())) return std::nullopt;
    std::vector<std::string_view> values;
    if (places.empty()) return text == pieces.front() ? std::optional(values) : std::nullopt;
    if (!matchFrom(*this, text, 1, pieces.front().size(), values)) return std::nullopt;
    return values;
}

std::string TextTemplate::filled(const std::vector<std::string>& values) const {
    std::string text(pieces.front());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto place = static_cast<std::size_t>(places[i] - 1);
        if (place < values.size()) text += values[place];
        text += pieces[i + 1];
    }
    return text;
}

}  // namespace vestige
