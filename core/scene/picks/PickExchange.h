#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"
#include "core/scene/picks/PointList.h"

namespace vestige {

/// All picks of the case as "label name,x,y,z", scene metres, every digit. The label tells where the point
/// belongs: "OBJECT | KEY | REPEAT | END", END a and b of a pair, p1, p2, ... of a path; the layer that the
/// point lies on follows where that is not KEY. What was fitted round a point does not fit into such a list.
std::string picksCsv(const SceneState& scene);

/// Where points without such labels go.
struct PicksTarget {
    std::string object;  ///< may be new
    std::string layer;   ///< that they lie on
};
struct ImportedPicks {
    std::vector<Measurement> changed;  ///< new, or in place of the case's of the same object
    std::size_t repeats = 0;           ///< taken
    std::size_t known = 0;             ///< that the case has already
};
/// Points of a list, in scene metres, as repeats of measurements: by their labels where these are as picksCsv
/// writes them, else each two in their order as a pair of `target`. Errors: ErrorCode::input, with `place`
/// and line, for labels of both kinds, an end without the other, a layer that the case lacks.
Result<ImportedPicks> importPicks(const SceneState& scene, std::span<const ListedPoint> points,
                                  const PicksTarget& target, const std::string& place);

}  // namespace vestige
