#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace vestige {

/// What the label of an exchanged pick says: "OBJECT | KEY | REPEAT | END", then " | LAYER" where the layer
/// is not KEY.
struct PickLabel {
    std::string object;
    std::string key;         ///< of Measurement::picks and paths
    std::size_t repeat = 1;  ///< from 1
    bool ofPath = false;
    std::size_t end = 0;  ///< 0: a, 1: b; of a path the corner, from 0
    std::string layer;
};

std::string textOf(const PickLabel& label);
/// Nothing for any other text.
std::optional<PickLabel> parsePickLabel(const std::string& text);

}  // namespace vestige
