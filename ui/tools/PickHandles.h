#pragma once

#include <QPointF>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/ViewCamera.h"
#include "core/scene/Scene.h"

class QPainter;

namespace vestige {

class Selection;
struct ViewTheme;

/// One point of one repeat of an object: an end of a pair, a corner of a path.
struct PickHandle {
    std::string object;
    std::string key;  ///< of Measurement::picks, or paths
    std::size_t repeat = 0;
    std::size_t place = 0;  ///< of a pair 0: a, 1: b
    bool ofPath = false;

    friend bool operator==(const PickHandle&, const PickHandle&) = default;
};

/// A repeat of the selected object, with its points where they are measured to; scene, metres.
struct PlacedRepeat {
    std::string key;
    std::size_t repeat = 0;
    bool ofPath = false;
    std::vector<Eigen::Vector3d> places;

    PickHandle handle(const std::string& object, std::size_t place) const {
        return {object, key, repeat, place, ofPath};
    }
};

/// Where a pick is measured to; scene, metres. At what was fitted round it, else at the measured point; there
/// in any case where `method` is its layer's own, which takes the points alone.
Eigen::Vector3d measuredPlace(const SceneState& scene, const PickedPoint& point, const std::string& method);

/// The repeats of the selected object that count for the selected method, pairs before paths, in the order of
/// their keys.
std::vector<PlacedRepeat> shownRepeats(const SceneState& scene, const Selection& selection);

/// The picked point that a handle stands for; null when the scene lacks it.
const PickedPoint* pointOf(const SceneState& scene, const PickHandle& handle);
/// The point that its distance is told to while it moves: the other end, the corner before it, of the first
/// corner the one behind it. Null where there is none.
const PickedPoint* neighbourOf(const SceneState& scene, const PickHandle& handle);

/// The handle within 7 pixels of a place of the picture, the nearest one.
std::optional<PickHandle> handleAt(const SceneState& scene, const Selection& selection,
                                   const ViewCamera& camera, const QPointF& position);

/// What of the handles stands out.
struct HandleLooks {
    bool shown = false;                       ///< the points can be taken hold of
    std::optional<PickHandle> pointed;        ///< under the cursor
    std::optional<PickHandle> active;         ///< moving, or for the keys to move
    std::optional<Eigen::Vector3d> proposed;  ///< where `active` would go; scene, metres
};

/// Every repeat as a thin line, and its points where they can be taken hold of. The line of a pair that is
/// the only one, and of the last path, is drawn as its object's mark already; a path that changes is drawn as
/// it would become.
void paintRepeats(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                  const SceneState& scene, const Selection& selection, const HandleLooks& looks);

}  // namespace vestige
