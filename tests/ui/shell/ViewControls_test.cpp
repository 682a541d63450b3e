#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QCursor>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>

#include "app/offscreen/OffscreenApplication.h"
#include "core/geometry/SectionSlab.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/document/Document.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/print/PdfPrinter.h"
#include "ui/view/SceneView.h"
#include "ui/view/SectionFrame.h"

namespace vestige {
namespace {

class Views : public testing::Test {
  public:
    Views() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        scans = test::writeSampleScans(folder.path());
        driver = start();
        EXPECT_TRUE(driver->window().openFiles({scans.target}));
        driver->settle();
    }

    std::unique_ptr<test::WindowDriver> start() {
        return std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), std::make_unique<PdfPrinter>(), nullptr,
            std::make_unique<InlineJobRunner>()));
    }

    SceneView& view() { return driver->window().view(); }
    Eigen::Vector3d direction() { return view().camera().direction(); }
    template <class Widget>
    Widget& find(const char* name) {
        return *driver->window().findChild<Widget*>(name);
    }
    QAction& action(const char* id) { return *driver->window().findChild<QAction*>(id); }

    /// A drag of the left button that starts on a point of the active pane.
    void drag(Qt::MouseButton button, const QPoint& from, const QPoint& by) {
        QWidget* widget = view().widget();
        QTest::mousePress(widget, button, Qt::NoModifier, from);
        for (const QPoint& place : {from + by / 2, from + by}) {
            QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button,
                             Qt::NoModifier);
            QApplication::sendEvent(widget, &move);
        }
        QTest::mouseRelease(widget, button, Qt::NoModifier, from + by);
        QApplication::processEvents();
    }

    test::TemporaryFolder folder;
    test::SampleScans scans;
    std::unique_ptr<test::WindowDriver> driver;
};

}  // namespace

TEST_F(Views, OppositeSidesAndProjection) {
    ASSERT_TRUE(driver->trigger("view.front"));
    EXPECT_NEAR(direction().y(), 1, 1e-9);
    EXPECT_TRUE(action("view.parallel").isChecked()) << "the key follows the camera";
    ASSERT_TRUE(driver->trigger("view.back"));
    EXPECT_NEAR(direction().y(), -1, 1e-9);
    ASSERT_TRUE(driver->trigger("view.right"));
    EXPECT_NEAR(direction().x(), -1, 1e-9);
    ASSERT_TRUE(driver->trigger("view.bottom"));
    EXPECT_NEAR(direction().z(), 1, 1e-9);
    ASSERT_TRUE(driver->trigger("view.iso"));
    EXPECT_FALSE(action("view.parallel").isChecked());
    const Eigen::Vector3d before = direction();
    ASSERT_TRUE(driver->trigger("view.parallel"));
    EXPECT_TRUE(view().camera().parallel);
    EXPECT_NEAR((direction() - before).norm(), 0, 1e-9);
    ASSERT_TRUE(driver->trigger("view.parallel"));
    EXPECT_FALSE(view().camera().parallel);
}

TEST_F(Views, ShowAllBringsTheSceneBack) {
    ASSERT_TRUE(driver->trigger("view.top"));
    const ViewCamera top = view().camera();
    ViewCamera away = top;
    away.position.x() += 400;
    away.focalPoint.x() += 400;
    away.halfHeight_m *= 7;
    view().setCamera(away);
    ASSERT_TRUE(driver->trigger("view.fit"));
    EXPECT_NEAR(view().camera().halfHeight_m, top.halfHeight_m, 0.02 * top.halfHeight_m);
    EXPECT_NEAR(view().camera().focalPoint.x(), top.focalPoint.x(), 0.1);
}

TEST_F(Views, FourOfThemAndBack) {
    ASSERT_TRUE(driver->trigger("view.four"));
    EXPECT_EQ(view().layout(), ViewLayout::four);
    ASSERT_TRUE(driver->trigger("view.top"));
    EXPECT_NEAR(direction().z(), -1, 1e-9) << "the active one turns";
    ASSERT_TRUE(driver->trigger("view.four"));
    EXPECT_EQ(view().layout(), ViewLayout::one);
}

TEST_F(Views, ASectionIsCutDraggedTypedAndReset) {
    ASSERT_TRUE(driver->trigger("view.top"));
    ASSERT_FALSE(find<QWidget>("section-bar").isVisible());
    ASSERT_TRUE(driver->trigger("view.section"));
    EXPECT_TRUE(find<QWidget>("section-bar").isVisible());
    ASSERT_TRUE(view().description().section);
    const SectionBox whole = *view().description().section;
    // The face of the largest x, dragged inwards by the mouse.
    const auto handles = sectionHandles(whole, view().camera());
    const auto face = std::find_if(handles.begin(), handles.end(), [](const SectionHandle& handle) {
        return handle.axis == 0 && handle.side == 1;
    });
    ASSERT_NE(face, handles.end());
    const double metre_px = 1 / view().camera().metresPerPixel(1);
    const QPoint inwards(-static_cast<int>(2 * metre_px), 0);
    drag(Qt::LeftButton, face->place.toPoint(), inwards);
    const SectionBox cut = *view().description().section;
    EXPECT_NEAR(cut.halfSize.x(), whole.halfSize.x() - 1, 0.05);
    EXPECT_NEAR(cut.centre.x() - cut.halfSize.x(), whole.centre.x() - whole.halfSize.x(), 1e-6);
    EXPECT_NEAR(find<QDoubleSpinBox>("section-size-x").value(), 2 * cut.halfSize.x(), 1e-3);
    find<QDoubleSpinBox>("section-turn").setValue(30);
    EXPECT_NEAR(view().description().section->heading_rad, 0.5235987756, 1e-6);
    find<QDoubleSpinBox>("section-size-z").setValue(0.5);
    EXPECT_NEAR(view().description().section->halfSize.z(), 0.25, 1e-9);
    ASSERT_TRUE(driver->trigger("view.section-reset"));
    EXPECT_EQ(*view().description().section, whole);
    ASSERT_TRUE(driver->trigger("view.section"));
    EXPECT_FALSE(view().description().section);
    ASSERT_TRUE(driver->trigger("view.section"));
    EXPECT_EQ(*view().description().section, whole) << "as it was";
}

TEST_F(Views, TheInsideOfASectionCanBeCutAway) {
    ASSERT_FALSE(action("view.section-invert").isChecked());
    ASSERT_TRUE(driver->trigger("view.section-invert"));
    ASSERT_TRUE(view().description().section) << "a box in the middle, so that something is left";
    EXPECT_TRUE(view().description().section->inverted);
    EXPECT_TRUE(action("view.section").isChecked());
    EXPECT_TRUE(find<QWidget>("section-bar").isVisible());
    find<QDoubleSpinBox>("section-turn").setValue(30);
    EXPECT_TRUE(view().description().section->inverted) << "figures leave it as it is";
    ASSERT_TRUE(driver->trigger("view.slab-z"));
    EXPECT_TRUE(view().description().section->inverted);
    const SectionBox kept = *view().description().section;
    ASSERT_TRUE(driver->trigger("view.save"));
    ASSERT_EQ(driver->scene().savedViews.size(), 1U);
    EXPECT_EQ(driver->scene().savedViews[0].section, kept);
    auto& check = find<QCheckBox>("section-inverted");
    EXPECT_TRUE(check.isChecked());
    check.click();
    EXPECT_FALSE(view().description().section->inverted);
    ASSERT_TRUE(driver->trigger("view.section"));
    EXPECT_FALSE(view().description().section);
    EXPECT_FALSE(action("view.section-invert").isChecked());
}

TEST_F(Views, SlabsStepByTheirThickness) {
    const std::pair<const char*, int> slabs[] = {{"view.slab-x", 0}, {"view.slab-y", 1}, {"view.slab-z", 2}};
    for (const auto& [id, axis] : slabs) {
        ASSERT_TRUE(driver->trigger(id));
        ASSERT_TRUE(view().description().section);
        EXPECT_EQ(thinAxis(*view().description().section), axis);
        const Eigen::Vector3d before = view().description().section->centre;
        ASSERT_TRUE(driver->trigger("view.slab-on"));
        EXPECT_NEAR((view().description().section->centre - before)[axis], 0.2, 1e-9);
        ASSERT_TRUE(driver->trigger("view.slab-back"));
        EXPECT_NEAR((view().description().section->centre - before).norm(), 0, 1e-9);
    }
    ASSERT_TRUE(driver->trigger("view.perspective"));
    ASSERT_TRUE(driver->trigger("view.slab-view"));
    EXPECT_TRUE(action("view.section").isChecked());
}

TEST_F(Views, ThePivotIsSetByDoubleClickMiddleClickAndKey) {
    ASSERT_TRUE(driver->trigger("view.top"));
    QWidget* widget = view().widget();
    const auto seen = view().camera().project(test::kBoxCorner);
    const QPoint place(static_cast<int>(seen->pixel.x()), static_cast<int>(seen->pixel.y()));
    const auto isThere = [&] { return view().pivot() && (*view().pivot() - test::kBoxCorner).norm() < 0.2; };
    QTest::mouseDClick(widget, Qt::LeftButton, Qt::NoModifier, place);
    EXPECT_TRUE(isThere());
    view().setPivot(std::nullopt);
    QTest::mouseClick(widget, Qt::MiddleButton, Qt::NoModifier, place);
    EXPECT_TRUE(isThere());
    view().setPivot(std::nullopt);
    QTest::mouseMove(widget, place);
    QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QApplication::sendEvent(widget, &move);
    ASSERT_TRUE(driver->trigger("view.pivot"));
    EXPECT_TRUE(isThere());
    const auto before = view().camera().project(*view().pivot());
    drag(Qt::LeftButton, QPoint(300, 500), QPoint(60, -40));
    const auto after = view().camera().project(*view().pivot());
    EXPECT_LT((before->pixel - after->pixel).norm(), 1) << "the view turns about it, wherever the mouse is";
}

TEST_F(Views, TheMouseFollowsTheHabitsChosenAndKeepsThem) {
    ASSERT_TRUE(driver->trigger("view.top"));
    const auto change = [&](Qt::MouseButton button) {
        const ViewCamera before = view().camera();
        drag(button, QPoint(400, 500), QPoint(0, -40));
        const ViewCamera after = view().camera();
        view().setCamera(before);
        if ((after.direction() - before.direction()).norm() > 1e-9) return 't';
        return std::abs(after.halfHeight_m - before.halfHeight_m) > 1e-9 ? 'z' : 'm';
    };
    const auto habits = [&] {
        return std::string{change(Qt::LeftButton), change(Qt::MiddleButton), change(Qt::RightButton)};
    };
    EXPECT_EQ(habits(), "tmm");
    ASSERT_TRUE(driver->trigger("view.mouse-cloudcompare"));
    EXPECT_EQ(habits(), "tzm");
    ASSERT_TRUE(driver->trigger("view.mouse-slicer"));
    EXPECT_EQ(habits(), "tmz");
    driver = start();
    EXPECT_TRUE(action("view.mouse-slicer").isChecked()) << "kept for the next start";
    ASSERT_TRUE(driver->trigger("view.mouse-own"));
}

TEST_F(Views, SavedViewsAreKeptFoundRenamedAndUndone) {
    ASSERT_TRUE(driver->trigger("view.front"));
    ASSERT_TRUE(driver->trigger("view.slab-y"));
    const ViewCamera front = view().camera();
    ASSERT_TRUE(driver->trigger("view.save"));
    ASSERT_EQ(driver->scene().savedViews.size(), 1U);
    auto& tree = find<QTreeWidget>("saved-views");
    auto* editor = tree.findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr) << "its name can be typed at once";
    editor->setText("Through the box");
    QTest::keyClick(editor, Qt::Key_Return);
    QTest::qWait(50);  // the editor hands its text over, then the list takes it
    ASSERT_EQ(driver->scene().savedViews.size(), 1U);
    EXPECT_EQ(driver->scene().savedViews[0].name, "Through the box");
    ASSERT_TRUE(driver->trigger("view.top"));
    ASSERT_TRUE(driver->trigger("view.section"));
    ASSERT_FALSE(view().description().section);
    const QRect row = tree.visualItemRect(tree.topLevelItem(0));
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, Qt::NoModifier, row.center());
    QApplication::processEvents();
    EXPECT_NEAR((view().camera().direction() - front.direction()).norm(), 0, 1e-9);
    ASSERT_TRUE(view().description().section);
    EXPECT_EQ(thinAxis(*view().description().section), 1);
    ASSERT_TRUE(driver->trigger("edit.undo"));
    EXPECT_EQ(driver->scene().savedViews[0].name, "View 1");
    ASSERT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->scene().savedViews.empty());
    EXPECT_EQ(tree.topLevelItemCount(), 0);
}

TEST_F(Views, PicturesOfAnySizeAndScaleAreWritten) {
    ASSERT_TRUE(driver->trigger("view.top"));
    ASSERT_TRUE(driver->trigger("view.screenshot"));
    ASSERT_TRUE(find<QWidget>("picture-bar").isVisible());
    driver->answers().picture = QString::fromStdString((folder / "view.png").string());
    find<QDoubleSpinBox>("picture-width").setValue(900);
    find<QDoubleSpinBox>("picture-height").setValue(700);
    find<QDoubleSpinBox>("picture-dpi").setValue(200);
    find<QCheckBox>("picture-to-scale").setChecked(true);
    find<QDoubleSpinBox>("picture-scale").setValue(100);
    find<QPushButton>("picture-save").click();
    ASSERT_TRUE(driver->settle());
    const QImage picture(driver->answers().picture);
    EXPECT_EQ(picture.size(), QSize(900, 700));
    EXPECT_EQ(picture.dotsPerMeterX(), 7874);
    ASSERT_TRUE(driver->trigger("view.screenshot"));
    EXPECT_FALSE(find<QWidget>("picture-bar").isVisible());
}

TEST_F(Views, ColoursHaveARangeThatCanBeTyped) {
    ASSERT_TRUE(driver->trigger("view.color-height"));
    ASSERT_TRUE(driver->trigger("view.color-range"));
    view().completePicture();
    const auto ends = view().colorEnds();
    ASSERT_TRUE(ends);
    EXPECT_NEAR(find<QDoubleSpinBox>("color-low").value(), ends->first, 1e-3);
    find<QDoubleSpinBox>("color-high").setValue(ends->first + 0.5);
    view().completePicture();
    EXPECT_NEAR(view().colorEnds()->second, ends->first + 0.5, 1e-3);
    find<QDoubleSpinBox>("color-cut").setValue(10);
    view().completePicture();
    EXPECT_GT(view().colorEnds()->first, ends->first - 1e-9);
    ASSERT_TRUE(driver->trigger("view.color-class"));
    EXPECT_EQ(view().description().colorMode, ColorMode::classification);
}

TEST_F(Views, GridNorthAndPointSizesAreSwitched) {
    ASSERT_TRUE(driver->trigger("view.grid"));
    EXPECT_TRUE(view().description().showGrid);
    EXPECT_FALSE(view().description().showNorthArrow) << "nothing says where north is";
    ASSERT_TRUE(driver->trigger("view.north"));
    ASSERT_TRUE(driver->trigger("view.near-size"));
    EXPECT_TRUE(view().description().sizeByDistance);
}

}  // namespace vestige
