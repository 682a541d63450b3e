#include "ui/tools/PickHandles.h"

#include <QPainter>
#include <cmath>

#include "core/scene/PickFrame.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kReach_px = 7;

const PickedPair* pairOf(const SceneState& scene, const PickHandle& handle) {
    const Measurement* held = scene.measurement(handle.object);
    if (!held) return nullptr;
    const auto found = held->picks.find(handle.key);
    if (found == held->picks.end() || handle.repeat >= found->second.size()) return nullptr;
    return &found->second[handle.repeat];
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
    for (const auto& [key, pairs] : object->picks) {
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (countsFor(scene, key, pairs[i], selection.method()))
                repeats.push_back({key, i, measuredPlace(scene, pairs[i].a, selection.method()),
                                   measuredPlace(scene, pairs[i].b, selection.method())});
    }
    return repeats;
}

const PickedPoint* pointOf(const SceneState& scene, const PickHandle& handle) {
    const PickedPair* pair = pairOf(scene, handle);
    return !pair ? nullptr : handle.second ? &pair->b : &pair->a;
}

const PickedPoint* otherEndOf(const SceneState& scene, const PickHandle& handle) {
    const PickedPair* pair = pairOf(scene, handle);
    return !pair ? nullptr : handle.second ? &pair->a : &pair->b;
}

std::optional<PickHandle> handleAt(const SceneState& scene, const Selection& selection,
                                   const ViewCamera& camera, const QPointF& position) {
    std::optional<PickHandle> nearest;
    double reach = kReach_px;
    for (const PlacedRepeat& repeat : shownRepeats(scene, selection)) {
        for (const bool second : {false, true}) {
            const auto at = seen(camera, second ? repeat.b : repeat.a);
            if (!at) continue;
            const double distance = std::hypot(at->x() - position.x(), at->y() - position.y());
            if (distance > reach) continue;
            reach = distance;
            nearest = PickHandle{selection.object(), repeat.key, repeat.repeat, second};
        }
    }
    return nearest;
}

void paintRepeats(QPainter& painter, const ViewTheme& theme, const ViewCamera& camera,
                  const SceneState& scene, const Selection& selection, bool handles,
                  const std::optional<PickHandle>& pointed, const std::optional<PickHandle>& active) {
    const std::vector<PlacedRepeat> repeats = shownRepeats(scene, selection);
    for (const PlacedRepeat& repeat : repeats) {
        const auto a = seen(camera, repeat.a);
        const auto b = seen(camera, repeat.b);
        if (!a || !b || repeats.size() < 2) continue;
        painter.setPen(QPen(theme.casing, 2.4));
        painter.drawLine(*a, *b);
        painter.setPen(QPen(theme.highlight, 1));
        painter.drawLine(*a, *b);
    }
    if (!handles) return;
    for (const PlacedRepeat& repeat : repeats) {
        for (const bool second : {false, true}) {
            const PickHandle handle{selection.object(), repeat.key, repeat.repeat, second};
            if (const auto at = seen(camera, second ? repeat.b : repeat.a))
                paintHandle(painter, theme, *at, handle == pointed, handle == active);
        }
    }
}

}  // namespace vestige
