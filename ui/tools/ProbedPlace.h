#pragma once

#include <QPoint>
#include <QString>
#include <optional>

#include "core/geometry/Picking.h"
#include "core/scene/Measurement.h"

namespace vestige {

/// A pick for the case, and where the view shows it.
struct ProbedPick {
    PickedPoint point;                     ///< for the case, with what was fitted
    Eigen::Vector3d measured;              ///< the measured point as the view shows it; world, metres
    std::optional<FittedFeature> feature;  ///< as the view shows it; world, metres

    /// What is measured to.
    const Eigen::Vector3d& place() const { return feature ? feature->position : measured; }
};

/// What a click at a place of the view takes.
struct ProbedPlace {
    QPoint position;  ///< in pixels of the view
    SnapMode snap = SnapMode::point;
    std::optional<Pick> under;       ///< the measured point there
    std::optional<ProbedPick> pick;  ///< nothing: a click takes nothing
    QString problem;                 ///< why a click takes nothing
    bool fitting = false;            ///< the answer is still to come
};

}  // namespace vestige
