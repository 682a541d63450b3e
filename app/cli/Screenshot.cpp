#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/Session.h"
#include "app/cli/ShownScene.h"
#include "app/cli/WindowPicture.h"
#include "app/offscreen/OffscreenApplication.h"
#include "core/base/Numbers.h"
#include "core/geometry/CameraProjection.h"
#include "core/pipeline/FrameView.h"
#include "core/pipeline/SavedViewPictures.h"
#include "core/pipeline/ScaledCamera.h"

namespace vestige::cli {
namespace {

struct Options {
    std::vector<std::string> inputs;
    std::string out;
    std::string view;  ///< empty: perspective, or the saved view's
    std::string size;  ///< empty: 1400x900, or all there is at the scale
    FilePart part;
    std::string overlay = "none";
    std::string color = "auto";
    std::string theme = "dark";
    double pointSize_px = 2;
    std::optional<double> scale;
    std::optional<double> dpi;
    std::string savedView;
    std::string section;
    bool sectionInvert = false;
    std::string projection = "auto";
    std::string map = "even";
    std::string range;
    bool grid = false;
    bool north = false;
    bool transparent = false;
    bool sizeByDistance = false;
    double pixelRatio = 1;
    bool window = false;
    std::string object;
    std::vector<std::string> actions;
};

/// Numbers with commas between them, all finite; nothing when the text is something else.
std::optional<std::vector<double>> numbersFromText(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto number = parseReal(text.substr(begin, end - begin));
        if (!number || !std::isfinite(*number)) return std::nullopt;
        numbers.push_back(*number);
        begin = end + 1;
    }
    return numbers;
}

std::optional<SectionBox> sectionFromText(const std::string& text) {
    const auto numbers = numbersFromText(text);
    if (!numbers || (numbers->size() != 6 && numbers->size() != 7)) return std::nullopt;
    const auto& n = *numbers;
    const Eigen::Vector3d low(n[0], n[1], n[2]);
    const Eigen::Vector3d high(n[3], n[4], n[5]);
    if (!(low.array() < high.array()).all()) return std::nullopt;
    SectionBox section{0.5 * (low + high), 0.5 * (high - low), 0};
    if (n.size() == 7) section.heading_rad = n[6] * std::numbers::pi / 180;
    return section;
}

std::string sectionProblem(const std::string& text) {
    return sectionFromText(text) ? ""
                                 : "xmin,ymin,zmin,xmax,ymax,zmax in metres is expected, each minimum below "
                                   "its maximum, after them, if wanted, how the box is turned in degrees";
}

std::string rangeProblem(const std::string& text) {
    const auto numbers = numbersFromText(text);
    const bool good = numbers && numbers->size() == 2 && numbers->at(0) < numbers->at(1);
    return good ? "" : "LOW,HIGH is expected, two numbers, e.g. 34,38.5";
}

/// "1400x900"; nothing when the text is something else.
std::optional<std::array<int, 2>> sizeFromText(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) return std::nullopt;
    const auto width = parseInteger(text.substr(0, cross));
    const auto height = parseInteger(text.substr(cross + 1));
    const auto drawable = [](const auto& side) { return side && *side >= 16 && *side <= 32000; };
    if (!drawable(width) || !drawable(height)) return std::nullopt;
    return std::array<int, 2>{static_cast<int>(*width), static_cast<int>(*height)};
}

std::string sizeProblem(const std::string& text) {
    return sizeFromText(text) ? "" : "WxH is expected, each 16 to 32000 pixels, e.g. 1400x900";
}

int runWindow(Session& session, const Options& options) {
    const std::string size = options.size.empty() ? "1400x900" : options.size;
    const std::string view = options.view.empty() ? "perspective" : options.view;
    const auto [width, height] = *sizeFromText(size);
    const OffscreenApplication application(options.pixelRatio);
    const Status drawn =
        drawWindow({options.inputs, options.out, *namedViewFromName(view), *overlayFromName(options.overlay),
                    options.object, options.actions, *themeFromName(options.theme), width, height});
    if (!drawn) return session.failed(drawn.error());
    session.print(options.out + ": the window, " + size + " pixels");
    session.printJson({{"path", options.out},
                       {"width", width},
                       {"height", height},
                       {"view", view},
                       {"overlay", options.overlay},
                       {"window", true}});
    return 0;
}

void setRange(Coloring& coloring, const Options& options) {
    coloring.map = *colorMapFromName(options.map);
    if (options.range.empty()) return;
    const std::vector<double> ends = *numbersFromText(options.range);
    coloring.height_m.low = coloring.intensity.low = ends[0];
    coloring.height_m.high = coloring.intensity.high = ends[1];
    coloring.reach_m = std::max(std::abs(ends[0]), std::abs(ends[1]));
}

/// From where, how large and at what scale.
Status setCamera(ViewDescription& view, const Options& options, bool kept) {
    const auto [width, height] = *sizeFromText(options.size.empty() ? "1400x900" : options.size);
    if (kept)
        view.camera = resized(view.camera, width, height);
    else
        view.camera = frameView(view, *namedViewFromName(options.view.empty() ? "perspective" : options.view),
                                width, height);
    if (options.projection != "auto")
        view.camera = withProjection(view.camera, options.projection == "parallel");
    if (!view.scale.denominator) return {};
    if (!view.camera.parallel)
        return fail(ErrorCode::usage, "a picture in perspective has no scale", "--scale",
                    "add --view top, front, left, ..., or --projection parallel");
    view.camera = options.size.empty() && !kept
                      ? holdingAllAtScale(view, view.camera, *view.scale.denominator, *view.scale.dpi)
                      : atScale(view.camera, *view.scale.denominator, *view.scale.dpi);
    return {};
}

/// True when the camera is that of the saved view.
Result<bool> takeSavedView(ShownScene& shown, const Options& options) {
    if (options.savedView.empty()) return false;
    for (const SavedView& saved : shown.savedViews) {
        if (saved.name != options.savedView) continue;
        const ColorMode asked = shown.view.colorMode;
        applySavedView(shown.view, saved);
        if (options.color != "auto") shown.view.colorMode = asked;
        if (saved.scale && !options.scale) shown.view.scale.denominator = *saved.scale;
        return options.view.empty();
    }
    std::string names;
    for (const SavedView& saved : shown.savedViews) names += (names.empty() ? "" : ", ") + saved.name;
    return fail(ErrorCode::usage, "the case has no saved view '" + options.savedView + "'", "--saved-view",
                names.empty() ? "the case has none" : "it has: " + names);
}

Status describe(ShownScene& shown, const Options& options) {
    ViewDescription& view = shown.view;
    view.theme = *themeFromName(options.theme);
    if (options.scale) view.scale.denominator = options.scale;
    if (options.dpi) view.scale.dpi = options.dpi;
    const Result<bool> kept = takeSavedView(shown, options);
    if (!kept) return fail(kept.error());
    if (view.scale.denominator && !view.scale.dpi) view.scale.dpi = 300;
    if (!options.section.empty()) view.section = sectionFromText(options.section);
    if (options.sectionInvert) {
        if (!view.section)
            return fail(ErrorCode::usage, "there is no section to invert", "--section-invert",
                        "add --section, or a --saved-view that has one");
        view.section->inverted = !view.section->inverted;
    }
    setRange(view.coloring, options);
    view.pointSize_px = options.pointSize_px * (view.scale.dpi ? std::max(1.0, *view.scale.dpi / 96) : 1.0);
    view.sizeByDistance = options.sizeByDistance;
    view.transparent = options.transparent;
    view.showGrid = options.grid;
    view.showNorthArrow = options.north || (view.scale.denominator && shown.knowsNorth);
    return setCamera(view, options, *kept);
}

std::string sizeText(const ViewCamera& camera) {
    return std::to_string(camera.width_px) + "x" + std::to_string(camera.height_px);
}

int runScreenshot(Session& session, const Options& options) {
    if (options.window && !options.part.whole())
        return session.failed(
            {ErrorCode::usage, "the window opens whole files", "--window", "leave out --every and --box"});
    if (options.window) return runWindow(session, options);
    if (options.inputs.empty())
        return session.failed(
            {ErrorCode::usage, "no input is named", "INPUT", "a case, or clouds and meshes"});
    const JobControl& control = session.control();
    const Overlay overlay = *overlayFromName(options.overlay);
    Result<ShownScene> shown =
        shownScene(options.inputs, options.part, overlay, options.color, session, control.sub(0, 0.9));
    if (!shown) return session.failed(shown.error());
    if (const Status described = describe(*shown, options); !described)
        return session.failed(described.error());
    const ViewDescription& view = shown->view;

    const OffscreenApplication application;
    const Status drawn = offscreenRenderer()->renderPng(view, options.out, control.sub(0.9, 1));
    if (!drawn) return session.failed(drawn.error());
    control.progress(1, "drawing");
    session.print(options.out + ": " + sizeText(view.camera) + " pixels, " +
                  std::to_string(view.layers.size()) + (view.layers.size() == 1 ? " layer" : " layers"));
    nlohmann::json layers = nlohmann::json::array();
    for (const ViewLayer& layer : view.layers)
        layers.push_back({{"name", layer.name}, {"points", layer.geometry->vertices.size()}});
    nlohmann::json told{{"path", options.out},
                        {"width", view.camera.width_px},
                        {"height", view.camera.height_px},
                        {"view", options.view.empty() ? "perspective" : options.view},
                        {"overlay", options.overlay},
                        {"color", std::string(name(view.colorMode))},
                        {"layers", layers}};
    if (!options.savedView.empty()) told["saved_view"] = options.savedView;
    if (view.scale.denominator) told["scale"] = *view.scale.denominator;
    if (view.scale.dpi) told["dpi"] = *view.scale.dpi;
    if (view.scale.denominator)
        told["pixels_per_m"] = pixelsPerMetre(*view.scale.denominator, *view.scale.dpi);
    session.printJson(told);
    return 0;
}

}  // namespace

Run declareScreenshot(CLI::App& command) {
    const auto options = std::make_shared<Options>();
    command
        .add_option(
            "INPUT", options->inputs,
            "One case (case.json, NAME.vestige), or any readable clouds and meshes; of these the first "
            "is the target of the overlays. None, with --window: the start page.")
        ->type_name("FILE");
    command.add_option("--out", options->out, "The picture, a PNG file.")
        ->required()
        ->type_name("PNG")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return std::filesystem::path(text).extension() == ".png" ||
                               std::filesystem::path(text).extension() == ".PNG"
                           ? std::string()
                           : std::string("the name of a PNG file is expected, e.g. scene.png");
            },
            "", "picture"));
    command.add_option("--view", options->view, "From where. Default: perspective.")
        ->check(CLI::IsMember({"perspective", "top", "front", "left", "iso", "back", "right", "bottom"}));
    command
        .add_option("--projection", options->projection,
                    "Default: auto, that is parallel but for perspective and iso.")
        ->check(CLI::IsMember({"auto", "perspective", "parallel"}));
    command.add_option(
        "--saved-view", options->savedView,
        "A view that the case keeps: its camera, section, colours and scale. What other options "
        "ask for goes before them.");
    command
        .add_option("--section", options->section,
                    "Shows only what lies in this box, metres; DEG turns it about its middle.")
        ->type_name("XMIN,YMIN,ZMIN,XMAX,YMAX,ZMAX[,DEG]")
        ->check(CLI::Validator(sectionProblem, "", "section"));
    command.add_flag("--section-invert", options->sectionInvert,
                     "Cuts away what lies in the section instead: of --section, or of the saved view.");
    command
        .add_option("--scale", options->scale,
                    "True to scale: 100 for 1:100. Parallel views only. Without --size the picture holds all "
                    "there is.")
        ->type_name("N")
        ->check(CLI::Range(0.01, 1e6));
    command
        .add_option("--dpi", options->dpi,
                    "Dots per inch, written into the file; lettering and points grow with them. Default with "
                    "--scale: 300.")
        ->check(CLI::Range(36.0, 2400.0));
    command.add_option("--size", options->size, "Pixels. Default: 1400x900.")
        ->type_name("WxH")
        ->check(CLI::Validator(sizeProblem, "", "size"));
    command
        .add_option("--overlay", options->overlay,
                    "registration: target and sources tinted; residual: distance to the target; source: each "
                    "layer in its colour. Default: none.")
        ->check(CLI::IsMember({"registration", "residual", "source", "none"}));
    command
        .add_option("--color", options->color,
                    "Colours without an overlay. Default: auto, that is rgb where a layer has colours, else "
                    "height.")
        ->check(CLI::IsMember({"auto", "height", "intensity", "rgb", "source", "class"}));
    command.add_option("--map", options->map, "Colours of heights. Default: even.")
        ->check(CLI::IsMember({"even", "viridis", "cividis", "plasma", "grey"}));
    command
        .add_option("--range", options->range,
                    "From where to where the colours run: m of height, intensity as recorded, m of distance. "
                    "Default: all but 1 % of the heights at either end, 2 % of the intensities; distances as "
                    "they spread.")
        ->type_name("LOW,HIGH")
        ->check(CLI::Validator(rangeProblem, "", "range"));
    command.add_flag("--grid", options->grid, "A grid in metres, on the ground or over a plan.");
    command.add_flag("--north", options->north, "A north arrow: along the y axis.");
    command.add_flag("--transparent", options->transparent, "No background.");
    command.add_flag("--size-by-distance", options->sizeByDistance, "Near points larger, in perspective.");
    command.add_option("--theme", options->theme, "light: for paper and projectors. Default: dark.")
        ->check(CLI::IsMember({"dark", "light"}));
    command.add_option("--point-size", options->pointSize_px, "Pixels. Default: 2.")
        ->check(CLI::Range(1.0, 16.0));
    addPartOptions(command, options->part);
    CLI::Option* window =
        command.add_flag("--window", options->window,
                         "The whole desktop window with the inputs opened, not the 3D view alone.");
    // The window shows what its own actions ask for.
    for (const char* own :
         {"--projection", "--saved-view", "--section", "--section-invert", "--scale", "--dpi", "--color",
          "--map", "--range", "--grid", "--north", "--transparent", "--size-by-distance", "--point-size"})
        window->excludes(command.get_option(own));
    command
        .add_option("--pixel-ratio", options->pixelRatio,
                    "With --window: pixels of the picture for each of the window, as on a screen of high "
                    "density. Default: 1.")
        ->needs(window)
        ->check(CLI::Range(1.0, 4.0));
    command
        .add_option("--object", options->object,
                    "With --window: the object that is selected before any action.")
        ->needs(window);
    command
        .add_option("--action", options->actions,
                    "With --window: an action to trigger before the picture is made (register.watch, "
                    "register.run, compare.swipe, view.panel-fit, ...); may be repeated.")
        ->needs(window)
        ->type_name("ID")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    return [options](Session& session) { return runScreenshot(session, *options); };
}

}  // namespace vestige::cli
