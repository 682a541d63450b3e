#pragma once

#include <QRectF>
#include <vector>

#include "core/pipeline/ViewRenderer.h"

class QPainter;

namespace vestige {

struct ViewTheme;

/// Paints a way that a layer can move, a head at either end, its label beside it. The label's place is added
/// to `taken`, which it keeps clear of. What lies behind the camera is left out.
void paintArrow(QPainter& painter, const ViewTheme& theme, const QRectF& picture, const ViewCamera& camera,
                const ViewArrow& arrow, std::vector<QRectF>& taken);

}  // namespace vestige
