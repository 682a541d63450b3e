#pragma once

#include "core/pipeline/ViewRenderer.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The scene's visible, loaded layers as a picture shows them. With `before` the registered layers stand at
/// their first pose. Residuals are computed when `overlay` asks for them, which takes seconds on large clouds
/// and can be cancelled. The camera is that of the caller.
ViewDescription describeView(const SceneState& scene, ColorMode colorMode, Overlay overlay,
                             bool before = false, const JobControl& control = {});

/// Whether the scene's y axis points north as far as the case knows: the target's file names a reference
/// system, or it is an aerial cloud with coordinates of a map grid (10 km and more from its origin).
bool knowsNorth(const SceneState& scene);

/// Leaves the objects out that the case hides; for pictures without a window, which keeps track of them.
void hideObjects(ViewDescription& view, const SceneState& scene);

/// Marks for the measured lengths (mean ends of the repeats), for `describeView(...).marks`.
std::vector<ViewMark> measurementMarks(const SceneState& scene, const MeasuredScene& measured);

}  // namespace vestige
