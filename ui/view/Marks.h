#pragma once

#include <QRectF>
#include <vector>

#include "core/pipeline/ViewRenderer.h"

class QPainter;

namespace vestige {

struct ViewTheme;

struct PaintedMark {
    ViewMark mark;
    bool pending = false;    ///< still being picked: dashed
    bool labelOnly = false;  ///< its line is part of a path that is painted already
};

/// Paints measured pairs on top of everything: line, ends, and the length in a label that keeps clear of the
/// other labels and of `taken`, the places of legend, scale bar and title (see LabelPlaces.h). Returns the
/// places of the labels.
std::vector<QRectF> paintMarks(QPainter& painter, const ViewTheme& theme, const QRectF& picture,
                               const ViewCamera& camera, const std::vector<PaintedMark>& marks,
                               std::vector<QRectF> taken);

}  // namespace vestige
