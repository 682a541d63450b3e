#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/scene/Scene.h"

namespace vestige {

/// A path of more points takes seconds to evaluate, and no one clicks as many.
constexpr std::size_t kMostPathPoints = 500;
constexpr std::size_t kMostPointsOfAnObject = 5000;

/// What a check allows until someone sets another tolerance.
constexpr double kUsualTolerance_m = 0.02;

/// The changes of what an object's kind is and is made of, in edits/KindEdits.cpp.

/// Settings that the new kind does not have go; picks and paths stay.
std::unique_ptr<SceneEdit> setKind(std::string object, MeasurementKind kind);
/// A value of the kind's own parameters; nothing: its default. A value that is not allowed changes nothing.
std::unique_ptr<SceneEdit> setKindSetting(std::string object, std::string key, std::optional<double> value);
/// One repetition more, of at most kMostPathPoints points, under `layer` (the key of the paths).
std::unique_ptr<SceneEdit> addPath(std::string object, std::string layer, PickedPath path);
std::unique_ptr<SceneEdit> removePath(std::string object, std::string layer, std::size_t repeat);
/// Puts `point` in the place of one point of a path. Changes nothing when there is no such point, or it is
/// the same already; in edits/MovePathPoint.cpp.
std::unique_ptr<SceneEdit> movePathPoint(std::string object, std::string layer, std::size_t repeat,
                                         std::size_t place, PickedPoint point);
/// Makes the object a known distance that checks the survey, or an object like the others; metres above 0.
std::unique_ptr<SceneEdit> setCheck(std::string object, std::optional<double> tolerance_m);

}  // namespace vestige
