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

/// One end of one repeat of an object.
struct PickHandle {
    std::string object;
    std::string key;  ///< of Measurement::picks
    std::size_t repeat = 0;
    bool second = false;  ///< the pair's b

    friend bool operator==(const PickHandle&, const PickHandle&) = default;
};

/// A repeat of the selected object, with its ends where they are measured to; scene, metres.
struct PlacedRepeat {
    std::string key;
    std::size_t repeat = 0;
    Eigen::Vector3d a;
    Eigen::Vector3d b;
};

/// Where a pick is measured to; scene, metres. At what was fitted round it, else at the measured point; there
/// in any case where `method` is its layer's own, which takes the points alone.
Eigen::Vector3d measuredPlace(const SceneState& scene, const PickedPoint& point, const std::string& method);

/// The repeats of the selected object that count for the selected method, in the order of their keys.
std::vector<PlacedRepeat> shownRepeats(const SceneState& scene, const Selection& selection);

/// The repeated end that a handle stands for; null when the scene lacks it.
const PickedPoint* pointOf(const SceneState& scene, const PickHandle& handle);
/// Its other end.
const PickedPoint* otherEndOf(const SceneState& scene, const PickHandle& handle);

/// The handle within 7 pixels of a place of the picture, the nearest one.
std::optional<PickHandle> handleAt(const SceneState& scene, const Selection& selection,
                                   const ViewCamera& camera, const QPointF& position);

/// Every repeat as a thin line; with `handles` its ends, too, where it can be taken hold of. One repeat is
/// drawn as its object's mark already.
void paintRepeats(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                  const SceneState& scene, const Selection& selection, bool handles,
                  const std::optional<PickHandle>& pointed, const std::optional<PickHandle>& active);

}  // namespace vestige
