#pragma once

#include <filesystem>
#include <string>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/simulation/SimulateScene.h"
#include "core/simulation/Survey.h"

namespace vestige {

/// Writes the clouds of a survey into `folder` (aerial.laz in UTM with its CRS; the handheld layers as PLY in
/// millimetres; photo.ply) and the rough pairs of every handheld layer (ID_picks.csv), and lists them in
/// `written`. ErrorCode::output on failure.
Status writeSurveyClouds(const Survey& survey, const SceneSpec& spec, const std::filesystem::path& folder,
                         const JobControl& control, SimulatedScene& written);

/// The case that names those files, with the analyst's aims and views; `file` is its place.
Status writeSimulatedCase(const Survey& survey, const SceneSpec& spec, const Aiming& aiming,
                          bool withHandheld, const std::filesystem::path& file);

/// What is true: poses of layers and objects, features with the layers that show them, lengths, how the
/// clicks were made.
Status writeTruth(const Survey& survey, const SceneSpec& spec, const SimulationOptions& options,
                  const AimOptions& aims, const std::filesystem::path& file);

}  // namespace vestige
