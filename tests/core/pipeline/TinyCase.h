#pragma once

#include <filesystem>

#include "core/pipeline/DocumentPrinter.h"
#include "core/pipeline/ViewRenderer.h"
#include "core/scene/Scene.h"

namespace vestige::test {

/// A road with a car-sized box and two posts, seen by an aerial scanner (metres, far from the world's
/// origin), and the box's front by a handheld one (millimetres, its own frame): small enough for a test and
/// registered in a second. Files are written into the folder.
struct TinyCase {
    explicit TinyCase(const std::filesystem::path& folder, bool withHandheld = true);

    SceneState scene;                       ///< layers named, not loaded
    Similarity truth;                       ///< target from handheld
    static constexpr double kWidth = 1.8;   ///< of the box, x
    static constexpr double kHeight = 1.4;  ///< of the box, z
    static Eigen::Vector3d origin() { return {483400, 4375661, 34}; }
};

/// Remembers what it was asked to draw and leaves a file that depends on it alone.
class NotingRenderer : public ViewRenderer {
  public:
    Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                     const JobControl& control) override;
    std::vector<ViewDescription> drawn;
};

/// Remembers the report.
class NotingPrinter : public DocumentPrinter {
  public:
    Status printPdf(const Report& report, const std::filesystem::path& pdf,
                    const JobControl& control) override;
    Report printed;
};

}  // namespace vestige::test
