#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QWidget>

#include "app/offscreen/OffscreenApplication.h"
#include "core/geometry/CameraProjection.h"
#include "core/geometry/PointCloudBuilder.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/view/Samples.h"
#include "ui/view/ClassColors.h"
#include "ui/view/PlanGrid.h"
#include "ui/view/SceneView.h"
#include "ui/view/SectionFrame.h"

using namespace vestige;
using namespace vestige::test;

namespace {

QImage drawn(const ViewDescription& view) {
    const TemporaryFolder folder;
    EXPECT_TRUE(offscreenRenderer()->renderPng(view, folder / "p.png", {}));
    return readPicture(folder / "p.png");
}

/// The quarter of the square with the least x and y, as a section.
SectionBox quarterOfTheSquare() {
    return {kFar + Eigen::Vector3d(2.5, 2.5, 0), {2.5, 2.5, 1}, 0};
}

std::shared_ptr<const TriangleMesh> twoTriangles() {
    PointCloudBuilder builder;
    for (const auto& corner : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 0, 0),
                               Eigen::Vector3d(10, 10, 0), Eigen::Vector3d(0, 10, 0)})
        builder.add(kFar + corner);
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

}  // namespace

TEST(Section, CutsPointsAndMeshes) {
    for (const bool mesh : {false, true}) {
        ViewDescription view = plainView(mesh ? twoTriangles() : flatSquare(300), NamedView::top, 300, 300);
        const int all = brightSpot(drawn(view)).pixels;
        view.section = quarterOfTheSquare();
        const Spot cut = brightSpot(drawn(view));
        EXPECT_NEAR(cut.pixels, 0.25 * all, 0.02 * all) << mesh;
        const auto middle = view.camera.project(view.section->centre);
        EXPECT_NEAR(cut.x, middle->pixel.x(), 2);
        EXPECT_NEAR(cut.y, middle->pixel.y(), 2);
        // Turned by an eighth it has the same size there.
        view.section->heading_rad = 0.785398163;
        view.section->centre = kFar + Eigen::Vector3d(5, 5, 0);
        EXPECT_NEAR(brightSpot(drawn(view)).pixels, 0.25 * all, 0.02 * all) << mesh;
        view.section->inverted = true;
        EXPECT_NEAR(brightSpot(drawn(view)).pixels, 0.75 * all, 0.02 * all) << mesh;
        EXPECT_EQ(brightSpot(drawn(view).copy(145, 145, 10, 10)).pixels, 0) << "the middle, " << mesh;
    }
}

TEST(HiddenPoints, ArePartsOfNoPicture) {
    for (const bool mesh : {false, true}) {
        ViewDescription view = plainView(mesh ? twoTriangles() : flatSquare(300), NamedView::top, 300, 300);
        const int all = brightSpot(drawn(view)).pixels;
        auto hidden = std::vector<std::uint8_t>(view.layers[0].geometry->vertices.size(), 0);
        // Of the mesh the corner of one triangle, of the points one half.
        if (mesh)
            hidden[1] = 1;
        else
            std::fill(hidden.begin(), hidden.begin() + static_cast<std::ptrdiff_t>(hidden.size() / 2), 1);
        view.layers[0].hidden = std::make_shared<const std::vector<std::uint8_t>>(hidden);
        EXPECT_NEAR(brightSpot(drawn(view)).pixels, 0.5 * all, 0.02 * all) << mesh;
    }
}

TEST(HiddenPoints, ComeAndGoInOneView) {
    QWidget window;
    SceneView view(offscreenSurface(), &window);
    window.resize(300, 300);
    view.widget()->resize(300, 300);
    window.show();
    QApplication::processEvents();
    ViewDescription described = plainView(twoTriangles(), NamedView::top, 300, 300);
    const auto shown = [&] {
        view.show(described);
        view.completePicture();
        return brightSpot(view.widget()->grab().toImage()).pixels;
    };
    const int all = shown();
    described.layers[0].hidden =
        std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{0, 1, 0, 0});
    EXPECT_NEAR(shown(), 0.5 * all, 0.03 * all);
    described.layers[0].hidden = nullptr;
    EXPECT_EQ(shown(), all);
    described.section = quarterOfTheSquare();
    described.section->inverted = true;
    EXPECT_NEAR(shown(), 0.75 * all, 0.03 * all);
    described.section->inverted = false;
    EXPECT_NEAR(shown(), 0.25 * all, 0.03 * all);
}

TEST(Section, WhatIsCutAwayIsNotPicked) {
    QWidget window;
    SceneView view(offscreenSurface(), &window);
    window.resize(400, 300);
    view.widget()->resize(400, 300);
    window.show();
    QApplication::processEvents();
    const ViewDescription description = plainView(flatSquare(100), NamedView::top);
    view.show(description);
    view.setPickIndex({std::make_shared<Octree>(std::shared_ptr<const PointCloud>(
        description.layers[0].geometry, &description.layers[0].geometry->vertices))});
    const auto at = [&](double x, double y) {
        const auto seen = view.camera().project(kFar + Eigen::Vector3d(x, y, 0));
        return view.pickAt({static_cast<int>(seen->pixel.x()), static_cast<int>(seen->pixel.y())});
    };
    EXPECT_TRUE(at(8, 8));
    view.setSection(quarterOfTheSquare());
    EXPECT_FALSE(at(8, 8));
    EXPECT_TRUE(at(2, 2));
    SectionBox rest = quarterOfTheSquare();
    rest.inverted = true;
    view.setSection(rest);
    EXPECT_TRUE(at(8, 8));
    EXPECT_FALSE(at(2, 2));
    view.setSection(std::nullopt);
    EXPECT_TRUE(at(8, 8));
}

TEST(Section, FacesSeenFromAsideCanBeDragged) {
    const SectionBox box{{1, 2, 3}, {2, 1, 0.5}, 0.3};
    const BoundingBox around{{-2, 0, 2}, {4, 4, 4}};
    const ViewCamera top = fitCamera(around, NamedView::top, 800, 600);
    EXPECT_EQ(sectionHandles(box, top).size(), 4U + 1U) << "the level faces are seen straight on";
    const ViewCamera oblique = fitCamera(around, NamedView::perspective, 800, 600);
    const auto handles = sectionHandles(box, oblique);
    EXPECT_EQ(handles.size(), 6U + 1U);
    for (const SectionHandle& handle : handles) {
        const auto found = handleAt(box, oblique, handle.place + QPointF(2, 1));
        ASSERT_TRUE(found);
        EXPECT_TRUE(found->same(handle));
    }
    EXPECT_FALSE(handleAt(box, oblique, {2, 2}));
}

TEST(PlanGrid, HasRoundSpacings) {
    ViewCamera camera = fitCamera({{0, 0, 0}, {40, 30, 5}}, NamedView::top, 800, 600);
    EXPECT_TRUE(showsPlan(camera));
    EXPECT_DOUBLE_EQ(gridSpacing_m(camera), 5);
    camera.halfHeight_m /= 100;
    EXPECT_NEAR(gridSpacing_m(camera), 0.05, 1e-12);
    EXPECT_FALSE(showsPlan(fitCamera({{0, 0, 0}, {40, 30, 5}}, NamedView::perspective, 800, 600)));
}

TEST(PlanGrid, DrawsLinesOnItsCoordinates) {
    ViewDescription view = plainView(onePoint(kFar), NamedView::top, 400, 300);
    view.camera = fitCamera({kFar, kFar + Eigen::Vector3d(12, 9, 0)}, NamedView::top, 400, 300);
    const QImage without = drawn(view);
    view.showGrid = true;
    const QImage with = drawn(view);
    const double spacing = gridSpacing_m(view.camera);
    const double x = std::ceil((kFar.x() + 3) / spacing) * spacing;
    const auto on = view.camera.project({x, kFar.y() + 4.3, kFar.z()});
    const int column = static_cast<int>(on->pixel.x());
    EXPECT_NE(with.pixel(column, 100), without.pixel(column, 100));
    EXPECT_EQ(with.pixel(column + 20, 100), without.pixel(column + 20, 100));
}

TEST(ClassColors, NameTheClassesOfTheSpecification) {
    EXPECT_EQ(className(2), "ground");
    EXPECT_EQ(className(6), "building");
    EXPECT_EQ(className(9), "water");
    EXPECT_EQ(className(11), "road surface");
    EXPECT_EQ(className(17), "bridge deck");
    EXPECT_EQ(className(40), "reserved");
    EXPECT_EQ(className(70), "of the user");
}

/// Values of the published tables between the colours that ours are made from.
TEST(ColorMaps, FollowThePublishedTables) {
    const auto near = [](const Rgb& color, int r, int g, int b) {
        EXPECT_NEAR(color[0], r, 6);
        EXPECT_NEAR(color[1], g, 6);
        EXPECT_NEAR(color[2], b, 6);
    };
    near(mapColor(ColorMap::viridis, 0.5, Theme::dark), 33, 145, 140);
    near(mapColor(ColorMap::viridis, 0.25, Theme::dark), 59, 82, 139);
    near(mapColor(ColorMap::viridis, 0.75, Theme::dark), 94, 201, 98);
    near(mapColor(ColorMap::plasma, 0.5, Theme::dark), 204, 71, 120);
    near(mapColor(ColorMap::cividis, 0.5, Theme::dark), 125, 124, 120);
}
