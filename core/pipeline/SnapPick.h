#pragma once

#include <optional>
#include <vector>

#include "core/base/JobControl.h"
#include "core/measurement/fit/Snap.h"
#include "core/scene/Layer.h"

namespace vestige {

/// snapFeature round a pick at `world_m` (scene metres) on a loaded layer, with what is known of the layer's
/// sensor. `view`: unit, from the eye; `path`: the layer's scannerPathOf, or null.
Result<FittedFeature> snapPick(const Layer& layer, const Eigen::Vector3d& world_m,
                               const Eigen::Vector3d& view, SnapMode mode, const ScannerPath* path = nullptr,
                               ClipRegion clips = {});

/// Where the scanner of an aerial layer flew, from the layer's points. Reads the layer's file once more where
/// the times of its points are not held: work for a job. Nothing where it cannot be told.
std::optional<ScannerPath> scannerPathOf(const Layer& layer, const JobControl& control);

}  // namespace vestige
