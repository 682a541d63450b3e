#pragma once

#include <optional>
#include <string>

#include "core/geometry/SectionBox.h"
#include "core/geometry/ViewCamera.h"

namespace vestige {

/// A way to look at the scene that the analyst named; the report prints those that say so.
struct SavedView {
    std::string name;  ///< unique in the case
    ViewCamera camera;
    std::optional<SectionBox> section;
    std::string colorMode;     ///< "height", as the command line has it
    std::optional<int> scale;  ///< of a parallel view: 100 for 1:100 in print; nothing: fills the page
    bool inReport = true;
};

}  // namespace vestige
