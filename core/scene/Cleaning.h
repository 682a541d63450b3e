#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/geometry/PointSet.h"
#include "core/scene/Layer.h"
#include "core/scene/SceneObject.h"

namespace vestige {

struct SceneState;

/// One step of cleaning a layer, for the report.
struct CleaningStep {
    std::string how;           ///< "lasso", "outliers", ...
    std::string parameters;    ///< as people read them: "inside, 2 m deep"; may be empty
    std::uint64_t points = 0;  ///< that it took out

    friend bool operator==(const CleaningStep&, const CleaningStep&) = default;
};

/// What was taken out of a layer, and of what: indices into the points as loaded mean nothing for another
/// file or another part of it. Immutable once it is in a layer.
struct Cleaning {
    PointSet removed;  ///< not empty, and not all
    std::uint32_t loadedPoints = 0;
    std::string sha256;
    std::vector<CleaningStep> steps;  ///< that `removed` comes from, in their order

    friend bool operator==(const Cleaning&, const Cleaning&) = default;
};

/// The layer's points as they were loaded, which indices of cleaning and objects refer to; null when the
/// layer has no data, or a preview.
std::shared_ptr<const LayerData> loadedData(const Layer& layer);
/// Index into the points as loaded of the point that the layer has now at `point`.
std::uint32_t loadedIndex(const LayerData& data, std::uint32_t point);
/// `points`, ascending indices into what the layer has now, as indices into the points as loaded.
PointSet loadedIndices(const LayerData& data, std::vector<std::uint32_t> points);

/// Whether `data` are what the layer's cleaning leaves.
bool isCleaned(const LayerData& data, const Cleaning* cleaning);
/// Why the layer's cleaning cannot be applied to the points that were loaded, as a sentence without a full
/// stop; nothing when it can, or when there is nothing to apply or no data.
std::optional<std::string> cleaningMismatch(const Layer& layer);
/// Whether the object's indices are of the points that the layer has.
bool belongsTo(const SceneObject& object, const Layer& layer);

/// The layer's cleaning with `points` (as loaded) taken out as well; null when that changes nothing.
/// ErrorCode::usage when nothing would be left or the layer is not loaded.
Result<std::shared_ptr<const Cleaning>> withRemoved(const Layer& layer, const PointSet& points,
                                                    CleaningStep step);

/// `wanted`, or with 2, 3, ... what no object of the scene is called yet.
std::string unusedObjectName(const SceneState& scene, const std::string& wanted);

}  // namespace vestige
