#pragma once

#include <string>
#include <vector>

#include "app/cli/FilePart.h"
#include "app/cli/Session.h"
#include "core/pipeline/ViewRenderer.h"
#include "core/scene/SavedView.h"

namespace vestige::cli {

struct ShownScene {
    ViewDescription view;
    std::vector<SavedView> savedViews;  ///< of a case
    bool knowsNorth = false;
};

/// What a picture of a case, or of clouds and meshes, shows: everything loaded; of a case the layers
/// that stand in the scene, registered where it lacks that. Of each
/// file `part` is read; of a case, where that is the whole, what the case says. `color` is the name of a
/// ColorMode or "auto". The camera is the caller's.
Result<ShownScene> shownScene(const std::vector<std::string>& inputs, const FilePart& part, Overlay overlay,
                              const std::string& color, const Session& session, const JobControl& control);

}  // namespace vestige::cli
