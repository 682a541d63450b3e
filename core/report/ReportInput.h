#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/JointAdjustment.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// A picture that the run has made for the report.
struct ReportPicture {
    enum class Kind { overview, before, after, closeUp };
    Kind kind = Kind::overview;
    std::string subject;  ///< layer id (before, after) or object (closeUp)
    std::filesystem::path png;
    std::string caption;
    bool toScale = false;  ///< shown at the size that its file's dots per inch give
};

struct StageTime {
    std::string title;
    double seconds = 0;
};

/// Everything that a report of a case is made from.
struct ReportInput {
    const SceneState& scene;  ///< loaded and registered
    const MeasuredScene& measured;
    std::vector<std::string> warnings;
    std::vector<ReportPicture> pictures;
    std::vector<StageTime> stages;
    std::vector<std::pair<std::string, std::string>> versions;  ///< component, version
    std::string date;                                           ///< ISO 8601
    const JointAdjustment* adjustment = nullptr;                ///< where layers were adjusted together
};

}  // namespace vestige
