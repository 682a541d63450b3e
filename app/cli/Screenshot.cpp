#include <CLI/App.hpp>
#include <array>
#include <nlohmann/json.hpp>

#include "app/cli/Session.h"
#include "app/cli/ShownScene.h"
#include "app/cli/WindowPicture.h"
#include "app/offscreen/OffscreenApplication.h"
#include "core/base/Numbers.h"
#include "core/pipeline/FrameView.h"

namespace vestige::cli {
namespace {

struct Options {
    std::vector<std::string> inputs;
    std::string out;
    std::string view = "perspective";
    std::string size = "1400x900";
    FilePart part;
    std::string overlay = "none";
    std::string color = "auto";
    std::string theme = "dark";
    double pointSize_px = 2;
    double scale = 1;
    bool window = false;
    std::vector<std::string> actions;
};

/// "1400x900"; nothing when the text is something else.
std::optional<std::array<int, 2>> sizeFromText(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) return std::nullopt;
    const auto width = parseInteger(text.substr(0, cross));
    const auto height = parseInteger(text.substr(cross + 1));
    const auto drawable = [](const auto& side) { return side && *side >= 16 && *side <= 16384; };
    if (!drawable(width) || !drawable(height)) return std::nullopt;
    return std::array<int, 2>{static_cast<int>(*width), static_cast<int>(*height)};
}

std::string sizeProblem(const std::string& text) {
    return sizeFromText(text) ? "" : "WxH is expected, each 16 to 16384 pixels, e.g. 1400x900";
}

int runWindow(Session& session, const Options& options) {
    const auto [width, height] = *sizeFromText(options.size);
    const OffscreenApplication application(options.scale);
    const Status drawn = drawWindow({options.inputs, options.out, *namedViewFromName(options.view),
                                     *overlayFromName(options.overlay), options.actions,
                                     *themeFromName(options.theme), width, height});
    if (!drawn) return session.failed(drawn.error());
    session.print(options.out + ": the window, " + options.size + " pixels");
    session.printJson({{"path", options.out},
                       {"width", width},
                       {"height", height},
                       {"view", options.view},
                       {"overlay", options.overlay},
                       {"window", true}});
    return 0;
}

int runScreenshot(Session& session, const Options& options) {
    if (options.window && !options.part.whole())
        return session.failed(
            {ErrorCode::usage, "the window opens whole files", "--window", "leave out --every and --box"});
    if (options.window) return runWindow(session, options);
    if (options.inputs.empty())
        return session.failed({ErrorCode::usage, "no input is named", "INPUT", "a case, or clouds and meshes"});
    const JobControl& control = session.control();
    const Overlay overlay = *overlayFromName(options.overlay);
    Result<ViewDescription> view =
        shownScene(options.inputs, options.part, overlay, options.color, session, control.sub(0, 0.9));
    if (!view) return session.failed(view.error());
    const auto [width, height] = *sizeFromText(options.size);
    view->camera = frameView(*view, *namedViewFromName(options.view), width, height);
    view->pointSize_px = options.pointSize_px;
    view->theme = *themeFromName(options.theme);

    const OffscreenApplication application;
    const Status drawn = offscreenRenderer()->renderPng(*view, options.out, control.sub(0.9, 1));
    if (!drawn) return session.failed(drawn.error());
    control.progress(1, "drawing");
    session.print(options.out + ": " + options.size + " pixels, " + std::to_string(view->layers.size()) +
                  (view->layers.size() == 1 ? " layer" : " layers"));
    nlohmann::json layers = nlohmann::json::array();
    for (const ViewLayer& layer : view->layers)
        layers.push_back({{"name", layer.name}, {"points", layer.geometry->vertices.size()}});
    session.printJson({{"path", options.out},
                       {"width", width},
                       {"height", height},
                       {"view", options.view},
                       {"overlay", options.overlay},
                       {"color", std::string(name(view->colorMode))},
                       {"layers", layers}});
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
        ->check(CLI::IsMember({"perspective", "top", "front", "left", "iso"}));
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
        ->check(CLI::IsMember({"auto", "height", "intensity", "rgb", "source"}));
    command.add_option("--theme", options->theme, "light: for paper and projectors. Default: dark.")
        ->check(CLI::IsMember({"dark", "light"}));
    command.add_option("--point-size", options->pointSize_px, "Pixels. Default: 2.")
        ->check(CLI::Range(1.0, 16.0));
    addPartOptions(command, options->part);
    CLI::Option* window =
        command.add_flag("--window", options->window,
                         "The whole desktop window with the inputs opened, not the 3D view alone.");
    command
        .add_option("--scale", options->scale,
                    "With --window: pixels of the picture for each of the window, as on a screen of high "
                    "density. Default: 1.")
        ->needs(window)
        ->check(CLI::Range(1.0, 4.0));
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
