#include "ui/view/PaneDrawing.h"

#include <vtkActor.h>
#include <vtkCullerCollection.h>
#include <vtkOpenGLRenderer.h>

namespace vestige {

PaneDrawing::PaneDrawing() {
    renderer->SetPass(pass);
    renderer->SetBackground(0, 0, 0);
    // VTK would leave out what the first picture does not show; SceneDrawing decides for both.
    renderer->GetCullers()->RemoveAllItems();
    renderer->AddViewProp(&grid.actor());
}

PaneDrawing::~PaneDrawing() = default;

}  // namespace vestige
