#pragma once

#include <QRectF>
#include <optional>

#include "ui/view/ColorScale.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// The visible layers with their colours, and the colour bar of `scale`, in a panel at the top right of
/// `inside`. Returns the place it takes; null when there is nothing to say.
QRectF paintLegend(QPainter& painter, const ViewTheme& theme, const QRectF& inside,
                   const ViewDescription& view, const std::optional<ColorScale>& scale);

}  // namespace vestige
