#pragma once

#include <vtkNew.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "ui/view/GroundGrid.h"
#include "ui/view/PicturePass.h"
#include "ui/view/VtkCamera.h"

class vtkOpenGLRenderer;

namespace vestige {

/// One camera's picture in a window: a renderer with a viewport, and how much of each layer's points it is to
/// draw. The props of the scene stand in every pane's renderer; what the graphics card holds of them is
/// shared.
struct PaneDrawing {
    PaneDrawing();
    ~PaneDrawing();
    PaneDrawing(const PaneDrawing&) = delete;
    PaneDrawing& operator=(const PaneDrawing&) = delete;

    vtkNew<vtkOpenGLRenderer> renderer;
    vtkNew<PicturePass> pass;
    GroundGrid grid;
    std::vector<std::vector<std::uint32_t>> wanted;  ///< by layer; empty for one that is not seen
    std::size_t wantedPoints = 0;
    double from = 0;  ///< the part of what is wanted that the next frame draws
    double to = 0;
    bool whole = true;   ///< what the card lacks is brought in
    bool meshes = true;  ///< the next frame draws them, and the grid
    double share = 0;    ///< drawn after it
};

}  // namespace vestige
