#include "core/pipeline/SavedViewPictures.h"

#include <cmath>

#include "core/geometry/CameraProjection.h"
#include "core/pipeline/DescribeView.h"
#include "core/pipeline/ScaledCamera.h"
#include "core/scene/PickFrame.h"

namespace vestige {
namespace {

constexpr int kWidth_px = 1400;
constexpr int kHeight_px = 900;
constexpr double kPrint_dpi = 220;  // the finest that a report's page keeps
constexpr double kPaperWidth_mm = 168;
constexpr double kPaperHeight_mm = 108;

int printedPixels(double mm) {
    return static_cast<int>(std::lround(mm / 25.4 * kPrint_dpi));
}

std::string twoDigits(std::size_t number) {
    return (number < 10 ? "0" : "") + std::to_string(number);
}

/// What is known where the cameras of the case's views stand: a cloud in a frame of its own would only
/// confuse.
void leaveOutUnplaced(ViewDescription& view, const SceneState& scene) {
    std::erase_if(view.layers, [&](const ViewLayer& shown) {
        const Layer* layer = scene.layer(shown.id);
        return !layer || !isPlaced(scene, *layer);
    });
}

}  // namespace

void applySavedView(ViewDescription& shown, const SavedView& view) {
    shown.camera = view.camera;
    shown.section = view.section;
    if (const auto mode = colorModeFromName(view.colorMode)) shown.colorMode = *mode;
}

std::vector<PlannedPicture> savedViewPictures(const SceneState& scene, const MeasuredScene& measured) {
    std::vector<PlannedPicture> pictures;
    for (const SavedView& saved : scene.savedViews) {
        if (!saved.inReport) continue;
        ViewDescription view = describeView(scene, ColorMode::height, Overlay::none);
        leaveOutUnplaced(view, scene);
        if (view.layers.empty()) return pictures;
        applySavedView(view, saved);
        view.marks = measurementMarks(scene, measured);
        std::string caption = saved.name;
        const bool toScale = saved.scale && view.camera.parallel;
        if (toScale) {
            view.camera = resized(view.camera, printedPixels(kPaperWidth_mm), printedPixels(kPaperHeight_mm));
            view.camera = atScale(view.camera, *saved.scale, kPrint_dpi);
            view.scale = {static_cast<double>(*saved.scale), kPrint_dpi};
            caption += ", at 1:" + std::to_string(*saved.scale) + " in print";
        } else {
            view.camera = resized(view.camera, kWidth_px, kHeight_px);
        }
        view.title = caption;
        view.theme = Theme::light;
        view.showNorthArrow = knowsNorth(scene);
        PlannedPicture picture;
        picture.file = "screenshots/view-" + twoDigits(pictures.size() + 1) + ".png";
        picture.subject = saved.name;
        picture.caption = caption;
        picture.toScale = toScale;
        picture.view = std::move(view);
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace vestige
