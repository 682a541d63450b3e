#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vestige {

/// A text with places %1 ... %9: literal pieces, and between two of them the number of a place.
struct TextTemplate {
    std::vector<std::string_view> pieces;  ///< one more than places; may be empty
    std::vector<int> places;               ///< 1 ... 9

    /// `text` must outlive the template.
    explicit TextTemplate(std::string_view text);

    /// Bytes of the pieces.
    std::size_t literalSize() const;
    /// Words of two letters or more in the pieces.
    int words() const;
    /// What stands at the places of `text`, in the order of `places`, each as short as possible; nothing
    /// where the pieces do not fit.
    std::optional<std::vector<std::string_view>> match(std::string_view text) const;
    /// Place %n filled with values[n - 1]; left out where there is none.
    std::string filled(const std::vector<std::string>& values) const;
};

}  // namespace vestige
