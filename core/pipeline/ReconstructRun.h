#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/OutputFolder.h"
#include "core/pipeline/DocumentPrinter.h"
#include "core/pipeline/OutputFile.h"
#include "core/pipeline/Recipe.h"
#include "core/pipeline/RegisterTogether.h"
#include "core/pipeline/ViewRenderer.h"
#include "core/report/ReportInput.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// A file that the results were computed from.
struct InputFile {
    std::string what;  ///< "case", "layer front", "picks of front"
    std::filesystem::path path;
    std::string sha256;
    std::string expectedSha256;  ///< what it was as it became part of the case, where it differs
};

/// What the stages of `reconstruct` hand on to each other.
struct ReconstructRun {
    SceneState scene;
    OutputFolder output;
    ViewRenderer* renderer = nullptr;
    DocumentPrinter* printer = nullptr;

    std::string date;  ///< ISO 8601, UTC, of the start
    std::vector<InputFile> inputs;
    PreparedLayers prepared;
    std::optional<JointAdjustment> adjustment;
    MeasuredScene measured;
    std::vector<ReportPicture> pictures;
    std::vector<StageTime> stages;
    std::vector<OutputFile> outputs;  ///< all that was written, the manifest too
    std::vector<std::string> notMade;
    std::vector<std::string> warnings;
};

/// The stages, a file each in stages/.
Status loadStage(ReconstructRun& run, const JobControl& control);
Status preprocessStage(ReconstructRun& run, const JobControl& control);
Status registerStage(ReconstructRun& run, const JobControl& control);
Status aimStage(ReconstructRun& run, const JobControl& control);
Status measureStage(ReconstructRun& run, const JobControl& control);
Status fuseStage(ReconstructRun& run, const JobControl& control);
Status pictureStage(ReconstructRun& run, const JobControl& control);
Status reportStage(ReconstructRun& run, const JobControl& control);
Status manifestStage(ReconstructRun& run, const JobControl& control);

}  // namespace vestige
