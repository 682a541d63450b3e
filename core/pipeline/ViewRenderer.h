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
#include "core/geometry/Octree.h"
#include "core/geometry/SectionBox.h"
#include "core/geometry/TriangleMesh.h"
#include "core/geometry/ViewCamera.h"
#include "core/pipeline/Coloring.h"

namespace vestige {

/// `classification` is by the ASPRS classes of LAS files; the command line says "class".
enum class ColorMode { height, intensity, rgb, source, classification };
std::string_view name(ColorMode mode);
std::optional<ColorMode> colorModeFromName(std::string_view name);

/// What `--overlay` asks for: registration tints source and target; residual colours the registered layers by
/// distance to the target.
enum class Overlay { none, registration, residual, source };
std::string_view name(Overlay overlay);
std::optional<Overlay> overlayFromName(std::string_view name);

/// What a picture stands on: dark for the screen in a dim room, light for paper and projectors.
enum class Theme { dark, light };
std::string_view name(Theme theme);
std::optional<Theme> themeFromName(std::string_view name);

/// How two pictures of one scene are laid into each other.
enum class CompareMode { swipe, blink, checkerboard };

/// A second picture in the same frame, to judge how well clouds fit: each layer says in ViewLayer::other how
/// it differs there.
struct ViewComparison {
    CompareMode mode = CompareMode::swipe;
    double divider = 0.5;     ///< swipe: the other picture stands left of this share of the width
    int tile_px = 96;         ///< checkerboard
    bool otherShown = false;  ///< blink: which of the two is shown now
    std::string name;         ///< of the scene as it is: "After"
    std::string otherName;    ///< "Before"
};

/// A layer in the other picture of a comparison.
struct ViewSide {
    Similarity worldFromLayer;
    bool visible = true;
};

struct ViewLayer {
    std::string id;
    std::string name;
    std::shared_ptr<const TriangleMesh> geometry;
    std::shared_ptr<const Octree> octree = nullptr;  ///< over the geometry's points; null: made when needed
    Similarity worldFromLayer;
    std::array<std::uint8_t, 3> tint{160, 180, 200};
    std::shared_ptr<const std::vector<float>> residual_m;  ///< signed, per point, NaN for none; may be null
    bool visible = true;
    bool isTarget = false;  ///< what the others are registered to; for Overlay::registration
    std::optional<ViewSide> other = std::nullopt;  ///< in the other picture; nothing: the same
    /// Per point, not 0: drawn in the colour of what is selected; neither drawn nor picked. Null: none.
    std::shared_ptr<const std::vector<std::uint8_t>> selected = nullptr;
    std::shared_ptr<const std::vector<std::uint8_t>> hidden = nullptr;
};

/// A measured pair drawn into the view with its length.
struct ViewMark {
    Eigen::Vector3d a;
    Eigen::Vector3d b;
    std::string label;  ///< "4.786 m ± 0.014 m"
    bool highlighted = false;
    std::string name = {};  ///< of what is measured; told where the label stands aside
};

/// A way that a layer can move, drawn as a line with a head at each end: straight for a slide, an arc for a
/// turn.
struct ViewArrow {
    std::vector<Eigen::Vector3d> path;  ///< world
    std::string label;
};

/// A line through more points than two: a polyline, the outline of an area, an arc as chords.
struct ViewPath {
    std::vector<Eigen::Vector3d> points;  ///< world
    std::string label;
    bool closed = false;
    bool highlighted = false;
    std::string name = {};  ///< of what is measured
};

/// A picture that is printed or laid on a drawing to scale.
struct PictureScale {
    std::optional<double> denominator;  ///< 100 for 1:100, noted on the picture; parallel cameras only
    std::optional<double> dpi;          ///< dots per inch, written into the file; lettering grows with it
    friend bool operator==(const PictureScale&, const PictureScale&) = default;
};

/// Everything a picture depends on: what is drawn is a function of this, in the window and without a display.
struct ViewDescription {
    std::vector<ViewLayer> layers;
    std::vector<ViewMark> marks;
    std::vector<ViewPath> paths;
    std::vector<ViewArrow> arrows;
    std::optional<SectionBox> section;  ///< what lies outside is not drawn
    std::optional<ViewComparison> comparison;
    ColorMode colorMode = ColorMode::height;
    Overlay overlay = Overlay::none;
    Theme theme = Theme::dark;
    Coloring coloring;
    PictureScale scale;
    double pointSize_px = 2;
    bool transparent = false;  ///< where nothing is drawn the picture has no colour
    bool eyeDomeLighting = true;
    bool showLegend = true;
    bool showScaleBar = true;
    bool showGrid = false;        ///< on the ground, in metres
    bool showNorthArrow = false;  ///< y is north
    bool sizeByDistance = false;  ///< near points larger, in perspective
    std::string title;
    ViewCamera camera;
};

/// Visible in either picture of a comparison.
inline bool isDrawn(const ViewLayer& layer) {
    return layer.visible || (layer.other && layer.other->visible);
}

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
