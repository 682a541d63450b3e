#include <gtest/gtest.h>

#include <QApplication>
#include <QWidget>

#include "app/offscreen/OffscreenApplication.h"
#include "core/geometry/PointSet.h"
#include "core/scene/Cleaning.h"
#include "core/scene/CleaningEdits.h"
#include "core/scene/SceneObject.h"
#include "tests/ui/tools/PickDriver.h"
#include "tests/ui/view/Samples.h"
#include "ui/document/Document.h"
#include "ui/tools/LoupePicture.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

using test::PickDriver;

const Eigen::Vector3d kMiddleOfTop(0, 0, 0.8);
/// On the ground, where the box's long side stands.
const Eigen::Vector3d kAtFoot(0.3, -0.53, 0);

/// What of the yard is the box.
PointSet boxOf(const PointCloud& cloud) {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
        const Eigen::Vector3d at = cloud.point(i);
        if (std::abs(at.x()) < 1.01 && std::abs(at.y()) < 0.51 && at.z() > 0.01) indices.push_back(i);
    }
    return PointSet::fromSorted(indices);
}

SceneObject boxObject(const SceneState& scene) {
    const Layer& yard = scene.layers.front();
    SceneObject box;
    box.name = "Box";
    box.kind = "other";
    box.layer = yard.id;
    box.points = std::make_shared<const PointSet>(boxOf(*yard.data->points));
    box.loadedPoints = static_cast<std::uint32_t>(yard.data->points->size());
    box.sha256 = yard.data->sha256;
    return box;
}

/// That the box is there for picks, snapping and loupe, or is not.
void expectBox(PickDriver& driver, bool there) {
    SceneView& view = driver.window().window().view();
    const auto pick = view.pickAt(driver.at(kMiddleOfTop));
    ASSERT_TRUE(pick);
    EXPECT_NEAR(pick->world.z(), there ? 0.8 : 0, 1e-6);

    driver.window().trigger("snap.edge");
    driver.hover(driver.at(kAtFoot));
    driver.click(driver.at(kAtFoot));
    const auto answered = [&] {
        return driver.hint().contains("No edge") || driver.hint().contains("second end");
    };
    EXPECT_TRUE(PickDriver::wait(answered)) << driver.hint().toStdString();
    EXPECT_EQ(driver.hint().contains("No edge"), !there) << driver.hint().toStdString();
    if (there) driver.click({60, 60}, Qt::RightButton);

    LoupePicture loupe;
    const QImage middle = loupe.draw(view, driver.at(kMiddleOfTop), 6, 120);
    const QImage ground = loupe.draw(view, driver.at({3.2, -3.2, 0}), 6, 120);
    const int points = test::brightSpot(middle).pixels;
    EXPECT_GT(points, 0) << "what lies under it is seen instead";
    EXPECT_GT(test::brightSpot(ground).pixels, 0);
}

TEST(HiddenParts, AreNotPickedSnappedToOrMagnified) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    Document& document = driver.window().window().document();
    document.perform(addObject(boxObject(driver.scene())));
    expectBox(driver, true);
    document.perform(setObjectVisible("Box", false));
    expectBox(driver, false);
    document.perform(setObjectVisible("Box", true));
    expectBox(driver, true);
}

TEST(HiddenParts, NorIsWhatCleaningTookOut) {
    PickDriver driver;
    driver.window().trigger("tool.distance");
    Document& document = driver.window().window().document();
    const Layer& yard = driver.scene().layers.front();
    auto cleaning = withRemoved(yard, boxOf(*yard.data->points), {"lasso", "inside", 0});
    ASSERT_TRUE(cleaning);
    document.perform(setCleaning(yard.id, *cleaning, "take out the box"));
    // Both while the points are still to be taken out and after it.
    expectBox(driver, false);
    driver.window().settle();
    expectBox(driver, false);
    document.undo();
    driver.window().settle();
    expectBox(driver, true);
}

TEST(HiddenParts, AreNotInTheLoupeEvenWhereTheyComeFirst) {
    // A square seen from so far that the loupe takes one point for many, all but one of them hidden.
    ViewDescription view = test::plainView(test::flatSquare(60), NamedView::top);
    view.layers[0].octree = std::make_shared<Octree>(
        std::shared_ptr<const PointCloud>(view.layers[0].geometry, &view.layers[0].geometry->vertices));
    auto hidden = std::vector<std::uint8_t>(60 * 60, 1);
    view.camera.halfHeight_m = 2000;
    const auto pixels = [&](std::vector<std::uint8_t> flags) {
        view.layers[0].hidden = std::make_shared<const std::vector<std::uint8_t>>(std::move(flags));
        QWidget window;
        SceneView shown(offscreenSurface(), &window);
        window.resize(400, 300);
        shown.widget()->resize(400, 300);
        window.show();
        QApplication::processEvents();
        shown.show(view);
        const auto at = shown.camera().project(test::kFar + Eigen::Vector3d(5, 5, 0));
        LoupePicture loupe;
        return test::brightSpot(loupe.draw(shown, {at->pixel.x(), at->pixel.y()}, 6, 120)).pixels;
    };
    EXPECT_EQ(pixels(hidden), 0);
    hidden[1234] = 0;
    EXPECT_GT(pixels(hidden), 0);
}

}  // namespace
}  // namespace vestige
