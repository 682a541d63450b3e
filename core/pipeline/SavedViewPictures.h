#pragma once

#include <vector>

#include "core/pipeline/PicturePlan.h"
#include "core/pipeline/ViewRenderer.h"
#include "core/scene/Scene.h"

namespace vestige {

/// What a saved view shows of `shown` (the scene's layers as describeView has them): its camera, section and
/// colours.
void applySavedView(ViewDescription& shown, const SavedView& view);

/// The pictures of the case's saved views that are for the report, in their order. One with a scale is drawn
/// for print at that scale, 168 x 108 mm.
std::vector<PlannedPicture> savedViewPictures(const SceneState& scene, const MeasuredScene& measured);

}  // namespace vestige
