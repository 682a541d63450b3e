#include "ui/tools/PickHandles.h"

#include <QPainter>
#include <cmath>

#include "core/measurement/kinds/KindSpec.h"
#include "core/pipeline/KindStrokes.h"
#include "core/scene/PickFrame.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kReach_px = 7;

/// The points of a repeat in their order; empty when the scene lacks it.
std::vector<const PickedPoint*> pointsOf(const SceneState& scene, const PickHandle& handle) {
    std::vector<const PickedPoint*> points;
    const Measurement* held = scene.measurement(handle.object);
    if (!held) return points;
    if (handle.ofPath) {
        const auto found = held->paths.find(handle.key);
        if (found == held->paths.end() || handle.repeat >= found->second.size()) return points;
        for (const PickedPoint& point : found->second[handle.repeat]) points.push_back(&point);
        return points;
    }
    const auto found = held->picks.find(handle.key);
    if (found == held->picks.end() || handle.repeat >= found->second.size()) return points;
    const PickedPair& pair = found->second[handle.repeat];
    return {&pair.a, &pair.b};
}

std::optional<QPointF> seen(const ViewCamera& camera, const Eigen::Vector3d& world) {
    const auto at = camera.project(world);
    if (!at) return std::nullopt;
    return QPointF(at->pixel.x(), at->pixel.y());
}

void paintHandle(QPainter& painter, const ViewTheme& theme, const QPointF& at, bool pointed, bool active) {
    const double radius = pointed || active ? 5.5 : 3;
    painter.setPen(QPen(theme.casing, 2));
    painter.setBrush(active ? theme.highlight : pointed ? theme.accent : theme.panel);
    painter.drawEllipse(at, radius + 1, radius + 1);
    painter.setPen(QPen(pointed || active ? theme.line : theme.highlight, 1.4));
    painter.drawEllipse(at, radius, radius);
    if (pointed) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.accent, 1.6));
        painter.drawEllipse(at, radius + 4, radius + 4);
    }
    painter.setBrush(Qt::NoBrush);
}

void paintLine(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
               const KindStroke& stroke) {
    const auto& places = stroke.points;
    if (places.size() < 2) return;
    const std::size_t last = stroke.closed && places.size() > 2 ? places.size() : places.size() - 1;
    for (const QPen& pen : {QPen(theme.casing, 2.4), QPen(theme.highlight, 1)}) {
        painter.setPen(pen);
        for (std::size_t i = 0; i < last; ++i) {
            const auto a = seen(camera, places[i]);
            const auto b = seen(camera, places[(i + 1) % places.size()]);
            if (a && b) painter.drawLine(*a, *b);
        }
    }
}

}  // namespace

Eigen::Vector3d measuredPlace(const SceneState& scene, const PickedPoint& point, const std::string& method) {
    const auto feature = sceneFeature(scene, point);
    return feature && method != methodOfKey(scene, point.layer) ? feature->position
                                                                : scenePosition(scene, point);
}

std::vector<PlacedRepeat> shownRepeats(const SceneState& scene, const Selection& selection) {
    std::vector<PlacedRepeat> repeats;
    const Measurement* object = scene.measurement(selection.object());
    if (!object) return repeats;
    const std::string& method = selection.method();
    for (const auto& [key, pairs] : object->picks)
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (countsFor(scene, key, pairs[i], method))
                repeats.push_back(
                    {key,
                     i,
                     false,
                     {measuredPlace(scene, pairs[i].a, method), measuredPlace(scene, pairs[i].b, method)}});
    // Paths may be left of another kind.
    if (kindSpec(object->kind).isPair()) return repeats;
    for (const auto& [key, paths] : object->paths)
        for (std::size_t i = 0; i < paths.size(); ++i) {
            if (!countsFor(scene, key, paths[i], method)) continue;
            PlacedRepeat repeat{key, i, true, {}};
            for (const PickedPoint& point : paths[i])
                repeat.places.push_back(measuredPlace(scene, point, method));
            repeats.push_back(std::move(repeat));
        }
    return repeats;
}

const PickedPoint* pointOf(const SceneState& scene, const PickHandle& handle) {
    const auto points = pointsOf(scene, handle);
    return handle.place < points.size() ? points[handle.place] : nullptr;
}

const PickedPoint* neighbourOf(const SceneState& scene, const PickHandle& handle) {
    const auto points = pointsOf(scene, handle);
    const std::size_t place = handle.place == 0 ? 1 : handle.place - 1;
    return place < points.size() ? points[place] : nullptr;
}

std::optional<PickHandle> handleAt(const SceneState& scene, const Selection& selection,
                                   const ViewCamera& camera, const QPointF& position) {
    std::optional<PickHandle> nearest;
    double reach = kReach_px;
    for (const PlacedRepeat& repeat : shownRepeats(scene, selection)) {
        for (std::size_t place = 0; place < repeat.places.size(); ++place) {
            const auto at = seen(camera, repeat.places[place]);
            if (!at) continue;
            const double distance = std::hypot(at->x() - position.x(), at->y() - position.y());
            if (distance > reach) continue;
            reach = distance;
            nearest = repeat.handle(selection.object(), place);
        }
    }
    return nearest;
}

void paintRepeats(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                  const SceneState& scene, const Selection& selection, const HandleLooks& looks) {
    std::vector<PlacedRepeat> repeats = shownRepeats(scene, selection);
    const Measurement* object = scene.measurement(selection.object());
    if (!object) return;
    const auto isActive = [&](const PlacedRepeat& repeat) {
        return looks.active && looks.active->place < repeat.places.size() &&
               *looks.active == repeat.handle(selection.object(), looks.active->place);
    };
    for (PlacedRepeat& repeat : repeats) {
        const bool changing = looks.proposed && repeat.ofPath && isActive(repeat);
        if (changing) repeat.places[looks.active->place] = *looks.proposed;
        if (repeats.size() < 2 && !changing) continue;
        for (const KindStroke& stroke : strokesOf(object->kind, object->settings, repeat.places))
            paintLine(painter, theme, camera, stroke);
    }
    if (!looks.shown) return;
    for (const PlacedRepeat& repeat : repeats) {
        for (std::size_t place = 0; place < repeat.places.size(); ++place) {
            const PickHandle handle = repeat.handle(selection.object(), place);
            if (const auto at = seen(camera, repeat.places[place]))
                paintHandle(painter, theme, *at, handle == looks.pointed, handle == looks.active);
        }
    }
}

}  // namespace vestige
