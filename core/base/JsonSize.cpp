#include "core/base/JsonSize.h"

#include <algorithm>

namespace vestige {

JsonSize jsonSize(std::string_view text) {
    JsonSize size;
    int depth = 0;
    bool inText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inText) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inText = false;
            continue;
        }
        inText = c == '"';
        const bool opens = c == '[' || c == '{';
        if (opens) ++depth;
        if (c == ']' || c == '}') --depth;
        if (opens || c == ',') ++size.values;
        size.depth = std::max(size.depth, depth);
    }
    return size;
}

}  // namespace vestige
