#include "app/cli/Session.h"

namespace vestige::cli {

const std::vector<Verb>& verbs() {
    static const std::vector<Verb> all{};
    return all;
}

}  // namespace vestige::cli
