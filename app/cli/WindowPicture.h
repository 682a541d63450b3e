#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/pipeline/ViewRenderer.h"

namespace vestige::cli {

struct WindowPicture {
    std::vector<std::string> inputs;  ///< one case, or clouds and meshes
    std::filesystem::path png;
    NamedView view = NamedView::perspective;
    Overlay overlay = Overlay::none;
    std::string object;                ///< selected before them; empty: none
    std::vector<std::string> actions;  ///< ids of the window's actions, triggered in this order
    Theme theme = Theme::dark;
    int width_px = 1400;
    int height_px = 900;
};

/// Opens the whole desktop window on the inputs, without a display, and writes its picture. Needs an
/// OffscreenApplication.
Status drawWindow(const WindowPicture& wanted);

}  // namespace vestige::cli
