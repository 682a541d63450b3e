#include "core/io/LooksLikeTileset.h"

#include "core/io/MappedFile.h"

namespace vestige {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

struct Marks {
    bool asset = false;
    bool root = false;
    bool error = false;
    bool vestige = false;

    void see(std::string_view key) {
        asset |= key == "asset";
        root |= key == "root";
        error |= key == "geometricError";
        vestige |= key == "vestige";
    }
};

/// The keys of the outermost object, without a tree.
Marks outermostKeys(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    Marks marks;
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos || text[begin] != '{') return marks;
    int depth = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '{' || c == '[') ++depth;
        if ((c == '}' || c == ']') && --depth == 0) break;
        if (c != '"') continue;
        const std::size_t from = ++i;
        while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
        if (i >= text.size()) break;
        const std::size_t next = text.find_first_not_of(kBlanks, i + 1);
        if (depth == 1 && next != std::string_view::npos && text[next] == ':')
            marks.see(text.substr(from, i - from));
    }
    return marks;
}

}  // namespace

bool looksLikeTilesetText(std::string_view text) {
    const Marks marks = outermostKeys(text);
    return marks.asset && (marks.root || marks.error) && !marks.vestige;
}

bool looksLikeTileset(const std::filesystem::path& file) {
    std::error_code problem;
    if (!std::filesystem::is_regular_file(file, problem)) return false;
    const Result<MappedFile> content = MappedFile::open(file);
    if (!content) return false;
    const Marks marks = outermostKeys(content->text());
    return marks.asset && marks.root && !marks.vestige;
}

}  // namespace vestige
