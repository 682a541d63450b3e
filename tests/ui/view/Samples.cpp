#include "tests/ui/view/Samples.h"

#include "core/geometry/PointCloudBuilder.h"

namespace vestige::test {

std::shared_ptr<const TriangleMesh> flatSquare(int side, const Eigen::Vector3d& corner) {
    PointCloudBuilder builder;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) builder.add(corner + 10.0 / (side - 1) * Eigen::Vector3d(x, y, 0));
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    return mesh;
}

std::shared_ptr<const TriangleMesh> repeated(const TriangleMesh& mesh, int times) {
    PointCloudBuilder builder;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        for (int time = 0; time < times; ++time) builder.add(mesh.vertices.point(i));
    auto result = std::make_shared<TriangleMesh>();
    result->vertices = std::move(builder).build();
    return result;
}

std::shared_ptr<const TriangleMesh> onePoint(const Eigen::Vector3d& place) {
    PointCloudBuilder builder;
    builder.add(place);
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    return mesh;
}

ViewDescription plainView(std::shared_ptr<const TriangleMesh> geometry, NamedView view, int width_px,
                          int height_px) {
    ViewDescription description;
    ViewLayer layer;
    layer.id = layer.name = "layer";
    layer.geometry = std::move(geometry);
    layer.tint = {255, 255, 255};
    description.layers.push_back(std::move(layer));
    description.colorMode = ColorMode::source;
    description.showLegend = false;
    description.showScaleBar = false;
    description.camera = fitCamera(bounds(description), view, width_px, height_px);
    return description;
}

Spot brightSpot(const QImage& picture) {
    Spot spot;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (qGray(picture.pixel(x, y)) > 100) {
                spot.x += x + 0.5;
                spot.y += y + 0.5;
                ++spot.pixels;
            }
    if (spot.pixels) {
        spot.x /= spot.pixels;
        spot.y /= spot.pixels;
    }
    return spot;
}

QImage readPicture(const std::filesystem::path& file) {
    return QImage(QString::fromStdString(file.string()));
}

}  // namespace vestige::test
