#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/pipeline/DocumentPrinter.h"
#include "core/pipeline/OutputFile.h"
#include "core/pipeline/ViewRenderer.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

struct Reconstruction {
    SceneState scene;  ///< loaded, registered, picks resolved
    MeasuredScene measured;
    std::vector<OutputFile> outputs;
    std::vector<std::string> notMade;  ///< outputs that need a renderer or printer that was not given
    std::vector<std::string> warnings;
    std::map<std::string, double> secondsPerStage;
};

/// The main job: load, preprocess, register, resolve aims, measure, and write everything the contract lists
/// into `outputFolder`. Without renderer or printer their outputs are listed in `notMade`. A layer whose
/// registration fails ends the job with ErrorCode::untrustworthy. Cancelled or failed, nothing half-written
/// stays and what stood in the folder is untouched. Layers that hold their data already are not read again.
/// Where the job fails, `reached` gets the scene as far as it came: with what failed registrations found.
Result<Reconstruction> reconstruct(SceneState scene, const std::filesystem::path& outputFolder,
                                   ViewRenderer* renderer, DocumentPrinter* printer,
                                   const JobControl& control, SceneState* reached = nullptr);

}  // namespace vestige
