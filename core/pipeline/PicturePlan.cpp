#include "core/pipeline/PicturePlan.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "core/base/Translation.h"
#include "core/pipeline/CloseUp.h"
#include "core/pipeline/DescribeView.h"
#include "core/pipeline/FrameView.h"
#include "core/pipeline/KindPaths.h"
#include "core/pipeline/MeasurementMarks.h"
#include "core/pipeline/SavedViewPictures.h"

namespace vestige {
namespace {

constexpr int kWidth = 1400;
constexpr int kHeight = 900;
/// Those that stand side by side in the report have fewer pixels, so that their lettering is larger there.
constexpr int kHalfWidth = 1050;
constexpr int kHalfHeight = 675;

/// What a caption adds when the view was cropped in height.
std::string heightNote(bool leftOut) {
    return leftOut ? say("; what hangs above is left out") : "";
}

/// How far above the ends of a length its object may reach: a roof over the sills of a car, little over a
/// box.
double clearance(const ViewMark& mark) {
    return std::clamp(2 * (mark.b - mark.a).norm(), 0.5, 1.0);
}

double top(const ViewMark& mark) {
    return std::max(mark.a.z(), mark.b.z());
}

/// World bounds of the points themselves; those of a turned box would be larger.
BoundingBox placedBounds(const PointCloud& cloud, const Similarity& worldFromLayer) {
    BoundingBox box;
    for (std::size_t i = 0; i < cloud.size(); ++i) box.add(worldFromLayer * cloud.point(i));
    return box;
}

/// A name as part of a file's: letters, digits and single dashes.
std::string slug(const std::string& name) {
    std::string text;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 128 && std::isalnum(byte))
            text += static_cast<char>(std::tolower(byte));
        else if (!text.empty() && text.back() != '-')
            text += '-';
    }
    while (!text.empty() && text.back() == '-') text.pop_back();
    return text.substr(0, 40);
}

std::string twoDigits(std::size_t number) {
    return (number < 10 ? "0" : "") + std::to_string(number);
}

void keepLayers(ViewDescription& view, const std::vector<std::string>& ids) {
    std::erase_if(view.layers, [&](const ViewLayer& layer) {
        return std::find(ids.begin(), ids.end(), layer.id) == ids.end();
    });
}

/// The target and what is registered to it; a cloud in a frame of its own would only confuse.
std::vector<std::string> placedLayers(const SceneState& scene) {
    std::vector<std::string> ids;
    for (const Layer& layer : scene.layers)
        if (layer.id == scene.target || layer.registration) ids.push_back(layer.id);
    return ids;
}

bool onPlacedLayers(const SceneState& scene, const std::vector<std::string>& layers) {
    const auto placed = placedLayers(scene);
    return std::all_of(layers.begin(), layers.end(), [&](const std::string& id) {
        return std::find(placed.begin(), placed.end(), id) != placed.end();
    });
}

class Planner {
  public:
    Planner(const SceneState& scene, const MeasuredScene& measured) : scene_(scene), measured_(measured) {
        // What the window happened to hide is part of the result all the same.
        for (Layer& layer : scene_.layers) layer.visible = true;
    }

    std::vector<PlannedPicture> plan() {
        overviews();
        for (PlannedPicture& picture : savedViewPictures(scene_, measured_))
            pictures_.push_back(std::move(picture));
        for (const Layer& layer : scene_.layers)
            if (layer.registration) registration(layer);
        closeUps();
        return std::move(pictures_);
    }

  private:
    void add(const std::string& name, ReportPicture::Kind kind, const std::string& subject,
             const std::string& caption, ViewDescription view) {
        view.title = caption;
        view.theme = Theme::light;  // they are printed
        const bool whole = kind == ReportPicture::Kind::overview;
        view.camera.width_px = whole ? kWidth : kHalfWidth;
        view.camera.height_px = whole ? kHeight : kHalfHeight;
        pictures_.push_back({"screenshots/" + name + ".png", kind, subject, caption, std::move(view)});
    }

    void overviews() {
        ViewDescription view = describeView(scene_, ColorMode::height, Overlay::none);
        hideObjects(view, scene_);
        keepLayers(view, placedLayers(scene_));
        if (view.layers.empty()) return;
        view.camera = frameView(view, NamedView::perspective, kWidth, kHeight);
        add("overview-perspective", ReportPicture::Kind::overview, {}, say("The site, coloured by height"),
            view);
        view.camera = frameView(view, NamedView::top, kWidth, kHeight);
        view.showNorthArrow = knowsNorth(scene_);
        add("overview-top", ReportPicture::Kind::overview, {}, say("The site from above, coloured by height"),
            view);
        measuredObjects();
    }

    void measuredObjects() {
        ViewDescription view = describeView(scene_, ColorMode::source, Overlay::none);
        keepLayers(view, placedLayers(scene_));
        BoundingBox box;
        double ceiling = -std::numeric_limits<double>::infinity();
        for (const MeasuredLength& length : measured_.lengths) {
            const auto mark = measurementMark(scene_, length);
            if (!mark || !onPlacedLayers(scene_, length.layers)) continue;
            box.add(mark->a);
            box.add(mark->b);
            ceiling = std::max(ceiling, top(*mark) + clearance(*mark));
            view.marks.push_back(*mark);
        }
        view.paths = placedPaths();
        for (const ViewPath& path : view.paths)
            for (const Eigen::Vector3d& point : path.points) {
                box.add(point);
                ceiling = std::max(ceiling, point.z() + 1);
            }
        if (box.empty()) return;
        double radius = 0;
        for (const ViewPath& path : view.paths)
            for (const Eigen::Vector3d& point : path.points)
                radius = std::max(radius, (point - box.centre()).norm());
        for (const ViewMark& mark : view.marks)
            radius = std::max({radius, (mark.a - box.centre()).norm(), (mark.b - box.centre()).norm()});
        radius += 0.5;
        const bool leftOut = cropView(view, scene_, box.centre(), 4 * radius, ceiling);
        view.camera = cameraAround(box.centre(), radius, {-0.5, 0.7, -0.6});
        add("overview-objects", ReportPicture::Kind::overview, {},
            say("The measured objects, coloured by scan") + heightNote(leftOut), view);
    }

    std::vector<ViewPath> placedPaths() const {
        MeasuredScene placed;
        for (const MeasuredKind& kind : measured_.kinds)
            if (onPlacedLayers(scene_, kind.layers)) placed.kinds.push_back(kind);
        return measurementPaths(scene_, placed);
    }

    void registration(const Layer& layer) {
        const BoundingBox box = placedBounds(*layer.data->points, sceneFromLayer(layer));
        for (const bool before : {true, false}) {
            ViewDescription view = describeView(scene_, ColorMode::source, Overlay::registration, before);
            keepLayers(view, {scene_.target, layer.id});
            const double radius = 0.5 * box.diagonal();
            const bool leftOut = cropView(view, scene_, box.centre(), 4 * radius, box.max.z() + 0.5);
            view.camera = cameraAround(box.centre(), radius, {-0.5, 0.7, -0.5});
            add("registration-" + slug(layer.id) + (before ? "-before" : "-after"),
                before ? ReportPicture::Kind::before : ReportPicture::Kind::after, layer.id,
                say(before ? "%1 at its first pose, over the global cloud"
                           : "%1 as registered, over the global cloud",
                    {layer.name}) +
                    heightNote(leftOut),
                std::move(view));
        }
    }

    /// One of each object, by the first method that measured it.
    void closeUps() {
        std::vector<std::string> done;
        for (const MeasuredLength& length : measured_.lengths) {
            if (std::find(done.begin(), done.end(), length.object) != done.end()) continue;
            const auto mark = measurementMark(scene_, length);
            if (!mark) continue;
            done.push_back(length.object);
            closeUp(length, *mark, done.size());
        }
        for (const MeasuredKind& kind : measured_.kinds) {
            if (kind.quantities.empty() || std::find(done.begin(), done.end(), kind.object) != done.end())
                continue;
            MeasuredScene one;
            one.kinds = {kind};
            const auto paths = measurementPaths(scene_, one, kind.method);
            if (paths.empty() || paths.front().points.size() < 2) continue;
            done.push_back(kind.object);
            pathCloseUp(kind, paths, done.size());
        }
    }

    /// The layers measured in, and what is registered with them.
    void keepMeasured(ViewDescription& view, const std::vector<std::string>& layers) const {
        const bool onlyTarget = layers.size() == 1 && layers.front() == scene_.target;
        keepLayers(view, onlyTarget || !onPlacedLayers(scene_, layers) ? layers : placedLayers(scene_));
    }

    void pathCloseUp(const MeasuredKind& kind, const std::vector<ViewPath>& paths, std::size_t number) {
        ViewDescription view = describeView(scene_, ColorMode::source, Overlay::none);
        keepMeasured(view, kind.layers);
        std::vector<Eigen::Vector3d> points;
        for (const ViewPath& path : paths)
            points.insert(points.end(), path.points.begin(), path.points.end());
        const CloseUpSphere sphere = sphereRound(points);
        double ceiling = points.front().z();
        for (const Eigen::Vector3d& point : points) ceiling = std::max(ceiling, point.z());
        ceiling += std::clamp(2 * sphere.radius_m, 0.5, 1.0);
        const bool leftOut = cropView(view, scene_, sphere.centre, 4 * sphere.radius_m, ceiling);
        const Eigen::Vector3d direction = closeUpDirection(view, kind.layers, points);
        view.camera = cameraAround(sphere.centre, sphere.radius_m, direction);
        if (view.layers.size() == 1 && direction.normalized().z() < -0.6) view.colorMode = ColorMode::height;
        view.pointSize_px = 3;
        view.paths = paths;
        for (ViewPath& path : view.paths) path.highlighted = true;
        add("figure-" + twoDigits(number) + "-" + slug(kind.object), ReportPicture::Kind::closeUp,
            kind.object,
            say("%1, by %2: %3 %4",
                {kind.object, say(kind.method), say(kind.quantities.front().label), paths.front().label}) +
                heightNote(leftOut),
            std::move(view));
    }

    void closeUp(const MeasuredLength& length, const ViewMark& mark, std::size_t number) {
        const bool onlyTarget = length.layers.size() == 1 && length.layers.front() == scene_.target;
        ViewDescription view = describeView(scene_, ColorMode::source, Overlay::none);
        keepMeasured(view, length.layers);
        const Eigen::Vector3d middle = 0.5 * (mark.a + mark.b);
        const double radius = 0.75 * (mark.b - mark.a).norm() + 0.05;
        const bool leftOut = cropView(view, scene_, middle, 4 * radius, top(mark) + clearance(mark));
        const Eigen::Vector3d direction = closeUpDirection(view, scene_, length, mark);
        view.camera = cameraAround(middle, radius, direction);
        // From above, a box on the road of the same cloud shows by its height; from the side a wheel by its
        // brightness, and a scan in another cloud by its tint.
        if (onlyTarget && direction.normalized().z() < -0.6) view.colorMode = ColorMode::height;
        view.pointSize_px = 3;
        view.marks = {mark};
        view.marks.front().highlighted = true;
        add("length-" + twoDigits(number) + "-" + slug(length.object), ReportPicture::Kind::closeUp,
            length.object,
            say("%1, by %2: %3", {length.object, say(length.method), mark.label}) + heightNote(leftOut),
            std::move(view));
    }

    SceneState scene_;
    const MeasuredScene& measured_;
    std::vector<PlannedPicture> pictures_;
};

}  // namespace

std::vector<PlannedPicture> planPictures(const SceneState& scene, const MeasuredScene& measured) {
    return Planner(scene, measured).plan();
}

}  // namespace vestige
