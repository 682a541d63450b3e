#pragma once

#include <string>
#include <vector>

#include "core/pipeline/ViewRenderer.h"
#include "core/report/ReportInput.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/Scene.h"

namespace vestige {

/// One picture to be made.
struct PlannedPicture {
    std::string file;  ///< "screenshots/overview-top.png"
    ReportPicture::Kind kind = ReportPicture::Kind::overview;
    std::string subject;  ///< layer id or object
    std::string caption;
    ViewDescription view;
    bool toScale = false;  ///< printed at the size that its dots per inch give
};

/// The pictures of a reconstruction: the site in perspective and from above, the measured objects together,
/// the case's saved views, every registered layer before and after, and a close-up of every measured object.
/// Descriptions share the layers' data; close-ups hold only the points around their object.
std::vector<PlannedPicture> planPictures(const SceneState& scene, const MeasuredScene& measured);

}  // namespace vestige
