#include "ui/view/SameDrawing.h"

#include <algorithm>

namespace vestige {
namespace {

bool samePlace(const Similarity& a, const Similarity& b) {
    return a.scale == b.scale && a.pose.matrix() == b.pose.matrix();
}

bool sameSide(const std::optional<ViewSide>& a, const std::optional<ViewSide>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return a->visible == b->visible && samePlace(a->worldFromLayer, b->worldFromLayer);
}

bool sameLayer(const ViewLayer& a, const ViewLayer& b) {
    return a.id == b.id && a.geometry == b.geometry && a.octree == b.octree &&
           samePlace(a.worldFromLayer, b.worldFromLayer) && a.tint == b.tint &&
           a.residual_m == b.residual_m && a.visible == b.visible && a.isTarget == b.isTarget &&
           a.hidden == b.hidden && a.selected == b.selected && sameSide(a.other, b.other);
}

bool sameComparison(const std::optional<ViewComparison>& a, const std::optional<ViewComparison>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return a->mode == b->mode && a->divider == b->divider && a->tile_px == b->tile_px &&
           a->otherShown == b->otherShown;
}

}  // namespace

bool sameDrawing(const ViewDescription& a, const ViewDescription& b) {
    return std::equal(a.layers.begin(), a.layers.end(), b.layers.begin(), b.layers.end(), sameLayer) &&
           a.section == b.section && sameComparison(a.comparison, b.comparison) &&
           a.colorMode == b.colorMode && a.overlay == b.overlay && a.theme == b.theme &&
           a.pointSize_px == b.pointSize_px && a.eyeDomeLighting == b.eyeDomeLighting &&
           a.showGrid == b.showGrid && a.showNorthArrow == b.showNorthArrow &&
           a.sizeByDistance == b.sizeByDistance && a.transparent == b.transparent &&
           a.coloring == b.coloring && a.scale == b.scale;
}

}  // namespace vestige
