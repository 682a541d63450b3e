#pragma once

#include <QColor>
#include <QImage>
#include <memory>

#include "core/pipeline/ViewRenderer.h"

namespace vestige::test {

/// `side` x `side` points on a flat square of 10 m, in the plane z = 0 of a frame far from the world's
/// origin.
inline const Eigen::Vector3d kFar{483000.25, 4375000.5, 34.75};
std::shared_ptr<const TriangleMesh> flatSquare(int side, const Eigen::Vector3d& corner = kFar);
/// Every point of it so many times, one after the other.
std::shared_ptr<const TriangleMesh> repeated(const TriangleMesh& mesh, int times);
/// One point there.
std::shared_ptr<const TriangleMesh> onePoint(const Eigen::Vector3d& place);
/// A description of one layer with nothing painted over it, in colours by source.
ViewDescription plainView(std::shared_ptr<const TriangleMesh> geometry, NamedView view, int width_px = 400,
                          int height_px = 300);

/// Mean position of the pixels brighter than the background, as pixel centres; nothing when there is none.
struct Spot {
    double x = 0;
    double y = 0;
    int pixels = 0;
};
Spot brightSpot(const QImage& picture);

/// The file's picture; a null one when there is none.
QImage readPicture(const std::filesystem::path& file);

}  // namespace vestige::test
