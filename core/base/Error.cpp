#include "core/base/Error.h"

namespace vestige {

std::string Error::sentence() const {
    std::string text;
    if (!place.empty()) text += place + ": ";
    text += message;
    if (!hint.empty()) text += "; " + hint;
    return text;
}

Error cancelledError() {
    return {ErrorCode::cancelled, "cancelled", {}, {}};
}

}  // namespace vestige
