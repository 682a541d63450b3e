#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/AerialScanner.h"
#include "core/simulation/Aims.h"
#include "core/simulation/HandheldScanner.h"
#include "core/simulation/Photogrammetry.h"
#include "core/simulation/RoughPairs.h"
#include "core/simulation/SceneModel.h"

namespace vestige {

struct HandheldLayer {
    std::string id;
    HandheldScan scan;
    std::vector<RoughPair> pairs;
};

/// Everything that was scanned of a scene, in memory.
struct Survey {
    SceneModel scene;
    Eigen::Vector3d worldFromSite;
    AerialScan aerial;
    std::vector<HandheldLayer> handheld;
    std::optional<PhotogrammetryScan> photo;

    /// The layers as the analyst sees them, in the order of the case: aerial, handheld, photogrammetry.
    std::vector<ShownLayer> shownLayers(bool withHandheld) const;
};

/// A feature counts as shown by this many echoes of its part within the radius.
struct ShownRule {
    double radius_m;
    std::uint32_t echoes;
};
/// Aerial: dense enough that a click within 6 pixels of 2 mm finds one of them.
inline constexpr ShownRule kShownByAerial{0.040, 12};
inline constexpr ShownRule kShownByHandheld{0.005, 20};
inline constexpr ShownRule kShownByPhotographs{0.060, 5};

/// Builds the scene and runs every scanner on it.
Result<Survey> surveyScene(const SceneSpec& spec, std::uint64_t seed, double seconds,
                           const JobControl& control);

}  // namespace vestige
