#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vestige {

/// A coordinate reference system's text as OGC 01-009 (WKT 1) and ISO 19162 (WKT 2) nest it: KEYWORD["text",
/// number, word, CHILD[...], ...]. Views into the text, which must outlive the tree.
struct WktNode {
    std::string_view keyword;
    std::vector<std::string_view> values;  ///< in order; texts without their quotes
    std::vector<WktNode> children;

    bool is(std::string_view upperKeyword) const;
    const WktNode* child(std::string_view upperKeyword) const;
    /// Value `place` as a number.
    std::optional<double> number(std::size_t place) const;
};

/// Nothing when the text is no such tree, or is nested deeper than any reference system (32).
std::optional<WktNode> parseWkt(std::string_view text);

}  // namespace vestige
