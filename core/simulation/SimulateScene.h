#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/simulation/SceneSpec.h"

namespace vestige {

struct SimulationOptions {
    std::uint64_t seed = 1;
    double seconds = 40;  ///< of flight
};

struct SimulatedScene {
    std::vector<std::string> files;               ///< what was written, relative to the folder
    std::map<std::string, std::uint64_t> points;  ///< per layer
    std::map<std::string, std::vector<std::string>> notMeasurable;  ///< objects without aims, per method
};

/// The survey of a synthetic scene: clouds, rough pairs, cases with the analyst's aims, and the truth,
/// written into `folder` (docs/simulation.md lists the files). The same seed gives the same files, whatever
/// the number of threads. Errors: the scene's (input), writing (output), cancelled; what was written before
/// stays whole.
Result<SimulatedScene> simulateScene(const SceneSpec& spec, const SimulationOptions& options,
                                     const std::filesystem::path& folder, const JobControl& control);

}  // namespace vestige
