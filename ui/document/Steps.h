#pragma once

#include <QString>
#include <QStringList>
#include <array>

#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// The way from files to a report.
enum class WayStep { import, align, clean, measure, report };
inline constexpr int kWaySteps = 5;

enum class StepState {
    waiting,   ///< a step before it comes first
    optional,  ///< nothing was done, and nothing has to be
    open,      ///< `missing` says what is left
    done
};

struct StepFacts {
    WayStep step = WayStep::import;
    StepState state = StepState::waiting;
    /// What is missing, the most important first: "front is not registered".
    QStringList missing;
    /// What there is, or what to do here: "3 scans, 18.5 M points".
    QString summary;
};

/// "Import", "Align", ...
QString titleOf(WayStep step);

/// Every step, in order. Pure. `reported`: a report was written of the case as it is.
std::array<StepFacts, kWaySteps> stepsOf(const SceneState& scene, const MeasuredScene& measured,
                                         bool reported);

/// The first step that something is missing of; the report where nothing is.
WayStep nextStep(const std::array<StepFacts, kWaySteps>& steps);

}  // namespace vestige
