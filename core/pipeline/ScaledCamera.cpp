#include "core/pipeline/ScaledCamera.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/CameraProjection.h"
#include "core/pipeline/FrameView.h"

namespace vestige {
namespace {
constexpr double kMetresPerInch = 0.0254;
constexpr double kMargin_m = 0.01;  // on paper
constexpr double kMost_px = 1e6;    // beyond any picture; keeps the number in range
}  // namespace

double pixelsPerMetre(double denominator, double dpi) {
    return dpi / kMetresPerInch / denominator;
}

ViewCamera atScale(ViewCamera camera, double denominator, double dpi) {
    camera = withProjection(camera, true);
    camera.halfHeight_m = 0.5 * camera.height_px / pixelsPerMetre(denominator, dpi);
    return camera;
}

ViewCamera holdingAllAtScale(const ViewDescription& view, ViewCamera camera, double denominator, double dpi) {
    camera = framed(view, withProjection(camera, true));
    const Eigen::Vector2d extent = extentSeen_m(view, camera);
    const double margin_px = 2 * kMargin_m * dpi / kMetresPerInch;
    const auto side = [&](double metres) {
        const double pixels = metres * pixelsPerMetre(denominator, dpi) + margin_px;
        return static_cast<int>(std::ceil(std::clamp(pixels, 16.0, kMost_px)));
    };
    camera.width_px = side(extent.x());
    camera.height_px = side(extent.y());
    return atScale(camera, denominator, dpi);
}

}  // namespace vestige
