#pragma once

#include <memory>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/scene/Cleaning.h"

namespace vestige {

/// What cleaning leaves of the points as loaded, with an octree of its own: the same points in the same order
/// with the same attributes, and the triangles all of whose corners are left. Takes about as long as indexing
/// the cloud did; any thread. ErrorCode::cancelled.
Result<std::shared_ptr<const LayerData>> cleanedData(const std::shared_ptr<const LayerData>& loaded,
                                                     const Cleaning& cleaning, const JobControl& control);

/// Gives the layer the data that its cleaning asks for, as loaded where it asks for nothing. Layers without
/// data, and previews, stay as they are. ErrorCode::input when the cleaning belongs to another file or part.
Status applyCleaning(Layer& layer, const JobControl& control);
/// The same for every layer.
Status applyCleaning(SceneState& scene, const JobControl& control);

}  // namespace vestige
