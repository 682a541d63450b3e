#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"
#include "core/geometry/ViewCamera.h"

namespace vestige {

enum class ColorMode { height, intensity, rgb, source };
std::string_view name(ColorMode mode);
std::optional<ColorMode> colorModeFromName(std::string_view name);

/// What `--overlay` asks for: registration tints source and target; residual colours the registered layers by
/// distance to the target.
enum class Overlay { none, registration, residual, source };
std::string_view name(Overlay overlay);
std::optional<Overlay> overlayFromName(std::string_view name);

struct ViewLayer {
    std::string id;
    std::string name;
    std::shared_ptr<const TriangleMesh> geometry;
    Similarity worldFromLayer;
    std::array<std::uint8_t, 3> tint{160, 180, 200};
    std::shared_ptr<const std::vector<float>> residual_m;  ///< per point, for Overlay::residual; may be null
    bool visible = true;
    bool isTarget = false;  ///< what the others are registered to; for Overlay::registration
};

/// A measured pair drawn into the view with its length.
struct ViewMark {
    Eigen::Vector3d a;
    Eigen::Vector3d b;
    std::string label;  ///< "4.786 m ± 0.014"
    bool highlighted = false;
};

/// Everything a picture depends on: what is drawn is a function of this, in the window and without a display.
struct ViewDescription {
    std::vector<ViewLayer> layers;
    std::vector<ViewMark> marks;
    ColorMode colorMode = ColorMode::height;
    Overlay overlay = Overlay::none;
    double pointSize_px = 2;
    bool eyeDomeLighting = true;
    bool showLegend = true;
    bool showScaleBar = true;
    std::string title;
    ViewCamera camera;
};

/// World bounds of the visible layers.
BoundingBox bounds(const ViewDescription& view);

/// Draws a description into a PNG; ui/view implements it, both mains hand it to the pipeline. Main thread
/// only.
class ViewRenderer {
  public:
    virtual ~ViewRenderer() = default;
    virtual Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                             const JobControl& control) = 0;
    /// What draws, for the report: "VTK 9.1.0".
    virtual std::string version() const { return {}; }
};

}  // namespace vestige
