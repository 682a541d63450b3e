#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Units.h"
#include "core/geometry/TriangleMesh.h"

namespace vestige::bench {

/// One search for a first pose whose answer is known.
struct Trial {
    std::shared_ptr<const TriangleMesh> target;  ///< metres
    TriangleMesh source;                         ///< in a frame and a unit of its own
    Similarity targetFromSource;                 ///< the truth
    std::optional<LengthUnit> unit;              ///< what the search is told of the source
    bool hasPlace = true;                        ///< whether the target shows what the source shows
    std::vector<Similarity> twins;               ///< other places that look the same
};

/// A family of trials: every number gives another one, the same on every run.
struct TrialSet {
    std::string name;
    double shift_m = 0.1;  ///< a pose within these of the truth counts as right
    double turn_deg = 1;
    std::function<Trial(std::uint64_t)> trial;
};

/// Any rotation, and a shift of up to `reach` units along each axis.
Pose anyPose(std::uint64_t trial, double reach);

/// Puts the source of a trial into a frame and unit of its own: turned and shifted at random, coordinates
/// divided by `metresPerUnit`. The truth follows.
void moveAway(Trial& trial, std::uint64_t number, double metresPerUnit = 1);

/// NAME=TARGET,SOURCE,TRUTH,METRES_PER_UNIT,SHIFT_M,TURN_DEG[,SIDE_M,POINTS]. TRUTH: a 4x4 matrix as text,
/// picks.csv (then what the registration makes of them), or a pose file (.json). SIDE_M crops the target to a
/// square round the source's place, POINTS thins it by taking every k-th. Throws with a sentence.
TrialSet setOfFiles(const std::string& text);
/// The pairs of shared/data/registration that overlap by more than half, as such texts; those present.
std::vector<std::string> sharedPairs();

/// Simulated stations and cars: a set by name, or nothing. Names by setNames().
std::optional<TrialSet> simulatedSet(const std::string& name);
std::vector<std::string> simulatedSets();

std::optional<TrialSet> carSet(const std::string& name);
std::vector<std::string> carSets();

}  // namespace vestige::bench
