#pragma once

#include <cstddef>
#include <string_view>

namespace vestige {

/// How large a tree a JSON text would make.
struct JsonSize {
    std::size_t values = 0;
    int depth = 0;
};

/// Told before there is a tree, so that a hostile text does not fill the memory. Knows just enough of JSON to
/// tell brackets and commas from text; of what is no JSON it says something of the same order.
JsonSize jsonSize(std::string_view text);

}  // namespace vestige
