#include <gtest/gtest.h>

#include <QAction>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>
#include <fstream>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/AtomicFile.h"
#include "core/pipeline/Reconstruct.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Cleaning.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/document/Document.h"
#include "ui/forms/ParameterEditor.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/jobs/ThreadedJobRunner.h"
#include "ui/shell/NoticeBar.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// The yard holds a box of 2 x 1 x 0.8 m round the origin; everything is done as the user does it.
class CleanWindow : public testing::Test {
  public:
    CleanWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        scans = test::writeSampleScans(folder.path());
    }

    void start(bool both = false, bool threads = false) {
        std::unique_ptr<JobRunner> jobs;
        if (threads)
            jobs = std::make_unique<ThreadedJobRunner>();
        else
            jobs = std::make_unique<InlineJobRunner>();
        driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::move(jobs)));
        std::vector<std::filesystem::path> files{scans.target};
        if (both) files.push_back(scans.source);
        EXPECT_TRUE(driver->window().openFiles(files));
        EXPECT_TRUE(driver->settle());
        driver->window().showNamedView(NamedView::top);
    }

    const Layer& layer(std::size_t place = 0) const { return driver->scene().layers[place]; }
    QWidget* view() { return driver->window().view().widget(); }
    QPoint at(double x, double y, double z = 0) {
        const auto shown = driver->window().view().camera().project({x, y, z});
        return {static_cast<int>(shown->pixel.x()), static_cast<int>(shown->pixel.y())};
    }
    void click(const QPoint& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mouseMove(view(), place);
        QTest::mouseClick(view(), Qt::LeftButton, modifiers, place);
    }
    void drag(const std::vector<QPoint>& way, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::mousePress(view(), Qt::LeftButton, modifiers, way.front());
        for (const QPoint& place : way) {
            QMouseEvent move(QEvent::MouseMove, place, view()->mapToGlobal(place), Qt::NoButton,
                             Qt::LeftButton, modifiers);
            QApplication::sendEvent(view(), &move);
        }
        QTest::mouseRelease(view(), Qt::LeftButton, modifiers, way.back());
        QApplication::processEvents();
    }
    /// Clicks round the box, a hand's breadth away, without closing.
    void clickRoundBox() {
        for (const auto& [x, y] :
             {std::pair(-1.15, -0.65), std::pair(1.15, -0.65), std::pair(1.15, 0.65), std::pair(-1.15, 0.65)})
            click(at(x, y));
    }
    void boxRound(double x0, double y0, double x1, double y1,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        driver->trigger("tool.box-select");
        drag({at(x0, y0), at(0.5 * (x0 + x1), 0.5 * (y0 + y1)), at(x1, y1)}, modifiers);
        EXPECT_TRUE(driver->settle());
    }
    void setParameter(const char* key, const QString& text) {
        for (auto* field : driver->window().findChildren<QWidget*>(key))
            if (auto* editor = qobject_cast<ParameterEditor*>(field->parentWidget()))
                emit editor->edited(text);
        QApplication::processEvents();
    }
    QString selected() const {
        return driver->window().findChild<QLabel*>("selected-points")->text().simplified();
    }
    std::size_t countSelected() const {
        const QString digits = selected().section(" points", 0, 0).remove(QRegExp("[^0-9]"));
        return digits.toULong();
    }
    QTreeWidget* parts() { return driver->window().findChild<QTreeWidget*>("parts"); }
    std::size_t points() const { return layer().data->points->size(); }

    test::TemporaryFolder folder;
    test::SampleScans scans;
    std::unique_ptr<test::WindowDriver> driver;
};

std::size_t magentaPixels(const QImage& picture) {
    std::size_t count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor color = picture.pixelColor(x, y);
            count += color.red() > 150 && color.blue() > 100 && color.green() < 0.6 * color.blue();
        }
    return count;
}

TEST_F(CleanWindow, ALassoIsClickedAndWhatItHoldsIsRemovedAndBroughtBack) {
    start();
    const std::size_t all = points();
    EXPECT_FALSE(driver->enabled("clean.remove"));
    ASSERT_TRUE(driver->trigger("tool.lasso"));
    clickRoundBox();
    EXPECT_EQ(selected(), "Nothing is selected");
    QTest::keyClick(view(), Qt::Key_Return);
    ASSERT_TRUE(driver->settle());
    const std::size_t count = countSelected();
    EXPECT_GT(count, 1500U);
    EXPECT_GT(magentaPixels(driver->window().view().grab()), 2000U) << "what is selected stands out";
    ASSERT_TRUE(driver->enabled("clean.remove"));
    ASSERT_TRUE(driver->trigger("clean.remove"));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(points(), all - count);
    EXPECT_EQ(layer().cleaning->removed.size(), count);
    EXPECT_EQ(layer().cleaning->steps[0].how, "lasso");
    EXPECT_EQ(layer().cleaning->steps[0].parameters, "inside");
    for (std::uint32_t i = 0; i < points(); ++i) {
        const Eigen::Vector3d point = layer().data->points->point(i);
        EXPECT_FALSE(std::abs(point.x()) < 1.05 && std::abs(point.y()) < 0.55) << point.transpose();
    }
    EXPECT_FALSE(driver->window().view().pickAt(at(0, 0, 0.8))) << "nothing is left to pick there";
    EXPECT_EQ(selected(), "Nothing is selected");
    EXPECT_TRUE(driver->textOf("edit.undo").startsWith("Undo remove "));
    ASSERT_TRUE(driver->trigger("edit.undo"));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(points(), all);
    ASSERT_TRUE(driver->trigger("edit.redo"));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(points(), all - count);
    ASSERT_TRUE(driver->trigger("clean.restore"));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(points(), all);
    EXPECT_FALSE(driver->enabled("clean.restore"));
}

TEST_F(CleanWindow, TheLassoIsClosedTakenBackAndGivenUpAsInOtherTools) {
    start();
    driver->trigger("tool.lasso");
    clickRoundBox();
    const QPoint far = at(-4, -4);
    click(far);
    QTest::keyClick(view(), Qt::Key_Backspace);
    EXPECT_TRUE(driver->label("hint").startsWith("4 corners"));
    QTest::mouseClick(view(), Qt::RightButton, Qt::NoModifier, at(0, 0));
    ASSERT_TRUE(driver->settle());
    const std::size_t byRightClick = countSelected();
    EXPECT_GT(byRightClick, 1500U);
    driver->trigger("clean.clear");
    EXPECT_EQ(selected(), "Nothing is selected");

    clickRoundBox();
    QTest::keyClick(view(), Qt::Key_Escape);
    QTest::mouseClick(view(), Qt::RightButton, Qt::NoModifier, at(0, 0));
    EXPECT_EQ(selected(), "Nothing is selected");

    for (const auto& [x, y] : {std::pair(-1.15, -0.65), std::pair(1.15, -0.65), std::pair(1.15, 0.65)})
        click(at(x, y));
    click(at(-1.15, 0.65));
    QTest::mouseDClick(view(), Qt::LeftButton, Qt::NoModifier, at(-1.15, 0.65));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(countSelected(), byRightClick);
    driver->trigger("clean.clear");

    clickRoundBox();
    click(at(-1.15, -0.65));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(countSelected(), byRightClick) << "the first corner closes";
    driver->trigger("clean.clear");

    drag({at(-1.15, -0.65), at(0, -0.65), at(1.15, -0.65), at(1.15, 0), at(1.15, 0.65), at(0, 0.65),
          at(-1.15, 0.65)});
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(countSelected(), byRightClick) << "a stroke is closed by letting go";
}

TEST_F(CleanWindow, AltTurnsTheViewWhileAnOutlineIsDrawn) {
    start();
    driver->trigger("tool.lasso");
    clickRoundBox();
    const Eigen::Vector3d before = driver->window().view().camera().position;
    drag({at(2, 2), at(2.5, 2.5), at(3, 3)}, Qt::AltModifier);
    EXPECT_GT((driver->window().view().camera().position - before).norm(), 0.1);
    EXPECT_TRUE(driver->label("hint").startsWith("4 corners"));
    QTest::keyClick(view(), Qt::Key_Escape);
    driver->trigger("tool.orbit");
    EXPECT_EQ(driver->label("hint"), "");
}

TEST_F(CleanWindow, TheDepthEndsACutBehindTheNearestSurface) {
    start();
    setParameter("depth_m", "0.4");
    boxRound(-1.15, -0.65, 1.15, 0.65);
    ASSERT_GT(countSelected(), 500U);
    EXPECT_TRUE(driver->label("selected-reach").startsWith("By box, from ") ||
                !driver->window().findChild<QLabel*>("selected-reach")->isVisible());
    driver->trigger("clean.remove");
    ASSERT_TRUE(driver->settle());
    std::size_t ground = 0;
    const PointCloud& whole = *loadedData(layer())->points;
    for (const std::uint32_t point : layer().cleaning->removed.indices())
        EXPECT_GT(whole.point(point).z(), 0.39);
    for (std::uint32_t i = 0; i < points(); ++i) {
        const Eigen::Vector3d place = layer().data->points->point(i);
        ground += std::abs(place.x()) < 0.9 && std::abs(place.y()) < 0.4 && place.z() < 0.01;
    }
    EXPECT_GT(ground, 100U) << "the ground beneath is still there";
    EXPECT_NE(layer().cleaning->steps[0].parameters.find("0.4 m deep"), std::string::npos);
}

TEST_F(CleanWindow, WhatIsTakenWithoutBeingSeenIsCounted) {
    start();
    auto* behind = driver->window().findChild<QLabel*>("selected-behind");
    driver->trigger("view.panel-clean");
    boxRound(-1.15, -0.65, 1.15, 0.65);
    EXPECT_FALSE(behind->isVisible()) << "from above the ground lies 0.8 m under the box";
    // From the front the yard's wall stands behind the box.
    driver->window().showNamedView(NamedView::front);
    driver->trigger("tool.box-select");
    drag({at(-1.1, 0, 0.9), at(0, 0, 0.5), at(1.1, 0, 0.05)});
    ASSERT_TRUE(driver->settle());
    ASSERT_TRUE(behind->isVisible());
    const QString count = behind->text().section(" of them", 0, 0).simplified().remove(QRegExp("[^0-9]"));
    EXPECT_GT(count.toULong(), 100U);
    EXPECT_LT(count.toULong(), countSelected());
    EXPECT_TRUE(driver->label("hint").contains("behind what is seen")) << driver->label("hint").toStdString();
    setParameter("depth_m", "1.2");
    drag({at(-1.1, 0, 0.9), at(0, 0, 0.5), at(1.1, 0, 0.05)});
    ASSERT_TRUE(driver->settle());
    EXPECT_GT(countSelected(), 100U);
    EXPECT_FALSE(behind->isVisible());
}

TEST_F(CleanWindow, TheCoordinatesUnderTheCursorAreToldBetweenClicks) {
    start();
    const auto told = [&](const QPoint& place) {
        QMouseEvent move(QEvent::MouseMove, place, view()->mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                         Qt::NoModifier);
        QApplication::sendEvent(view(), &move);
        QTest::qWait(120);
        return driver->label("coordinates");
    };
    for (const char* tool : {"tool.lasso", "tool.box-select"}) {
        driver->trigger("tool.orbit");
        told({1, 1});
        driver->trigger(tool);
        EXPECT_TRUE(told(at(0, 0, 0.8)).contains("0.800"))
            << tool << driver->label("coordinates").toStdString();
        click(at(-1.15, -0.65));
        EXPECT_FALSE(told(at(0, 0, 0.8)).isEmpty()) << "while an outline is drawn";
        EXPECT_TRUE(told(at(2.5, -2.5)).contains("0.000")) << driver->label("coordinates").toStdString();
        QTest::keyClick(view(), Qt::Key_Escape);
    }
}

TEST_F(CleanWindow, ShiftAddsCtrlTakesAwayAndTheOutsideCanBeTaken) {
    start();
    boxRound(-1.15, -0.65, 0, 0.65);
    const std::size_t left = countSelected();
    boxRound(0, -0.65, 1.15, 0.65, Qt::ShiftModifier);
    const std::size_t both = countSelected();
    EXPECT_GT(both, left + 500);
    boxRound(-1.15, -0.65, 0, 0.65, Qt::ControlModifier);
    EXPECT_NEAR(static_cast<double>(countSelected()), static_cast<double>(both - left), 60);
    driver->trigger("clean.invert");
    EXPECT_EQ(countSelected() + both - left, points());
    setParameter("side", "outside");
    boxRound(-1.15, -0.65, 1.15, 0.65);
    EXPECT_NEAR(static_cast<double>(countSelected()), static_cast<double>(points() - both), 60);
    setParameter("side", "inside");
    boxRound(-1.15, -0.65, 1.15, 0.65);
    ASSERT_TRUE(driver->trigger("clean.keep"));
    ASSERT_TRUE(driver->settle());
    EXPECT_NEAR(static_cast<double>(points()), static_cast<double>(both), 60);
    EXPECT_EQ(layer().cleaning->steps[0].how, "all but box");
}

TEST_F(CleanWindow, EverythingCannotBeTakenOut) {
    start();
    boxRound(-5.5, -5.5, 5.5, 5.5);
    ASSERT_EQ(countSelected(), points());
    driver->trigger("clean.remove");
    EXPECT_FALSE(layer().cleaning);
    EXPECT_TRUE(driver->window().findChild<NoticeBar*>("notice")->text().contains("nothing would be left"));
}

TEST_F(CleanWindow, OutliersGroundAndObjectsAreFoundByTheirButtons) {
    std::ofstream(scans.target, std::ios::app) << "0 0 2.2\n-2 3 1.9\n3 -3 2.4\n";
    start();
    ASSERT_TRUE(driver->trigger("view.panel-clean"));
    ASSERT_TRUE(driver->trigger("clean.outliers"));
    ASSERT_TRUE(driver->settle());
    EXPECT_GE(countSelected(), 3U);
    EXPECT_LT(countSelected(), 200U);
    ASSERT_TRUE(driver->trigger("clean.remove"));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(layer().cleaning->steps[0].how, "outliers");
    EXPECT_NE(layer().cleaning->steps[0].parameters.find("Limit: 3 SD"), std::string::npos);

    ASSERT_TRUE(driver->trigger("clean.ground"));
    ASSERT_TRUE(driver->settle());
    const std::size_t ground = countSelected();
    EXPECT_GT(ground, 14000U);
    EXPECT_LT(ground, 17500U);

    ASSERT_TRUE(driver->trigger("clean.objects"));
    ASSERT_TRUE(driver->settle());
    EXPECT_TRUE(driver->textOf("edit.undo").startsWith("Undo separate objects"));
    const auto& objects = driver->scene().objects;
    const auto box = std::find_if(objects.begin(), objects.end(), [](const SceneObject& object) {
        return object.kind == "debris" && std::abs(object.size_m[0] - 2.0) < 0.1;
    });
    ASSERT_NE(box, objects.end());
    EXPECT_NEAR(box->size_m[1], 1.0, 0.1);
    EXPECT_NEAR(box->size_m[2], 0.75, 0.1);
    EXPECT_EQ(static_cast<std::size_t>(parts()->topLevelItemCount()), objects.size());
    const std::size_t before = objects.size();
    driver->trigger("clean.objects");
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(driver->scene().objects.size(), before) << "asked again, they are not listed twice";
    ASSERT_TRUE(driver->trigger("edit.undo"));
    ASSERT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->scene().objects.empty());
}

TEST_F(CleanWindow, AnObjectIsMadeNamedHiddenLookedAtSelectedAndForgotten) {
    start();
    boxRound(-1.15, -0.65, 1.15, 0.65);
    const std::size_t count = countSelected();
    ASSERT_TRUE(driver->trigger("clean.make-object"));
    ASSERT_TRUE(driver->settle());
    ASSERT_EQ(driver->scene().objects.size(), 1U);
    EXPECT_EQ(driver->scene().objects[0].points->size(), count);
    auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(editor) << "its name is being typed";
    editor->selectAll();
    QTest::keyClicks(editor, "Carton");
    QTest::keyClick(editor, Qt::Key_Return);
    QApplication::processEvents();
    QApplication::processEvents();
    EXPECT_EQ(driver->scene().objects[0].name, "Carton");
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo rename Object 1 to Carton");

    ASSERT_EQ(parts()->topLevelItemCount(), 1);
    ASSERT_TRUE(driver->window().view().pickAt(at(0, 0, 0.8)));
    parts()->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
    QApplication::processEvents();
    EXPECT_FALSE(driver->scene().objects[0].visible);
    EXPECT_FALSE(driver->window().view().pickAt(at(0, 0, 0.8))) << "what is hidden is not picked";
    EXPECT_EQ(points(), loadedData(layer())->points->size()) << "but still in the scene";
    ASSERT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->window().view().pickAt(at(0, 0, 0.8)));

    parts()->setCurrentItem(parts()->topLevelItem(0));
    QApplication::processEvents();
    ASSERT_TRUE(driver->trigger("part.select"));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(countSelected(), count);
    const double reach = driver->window().view().camera().halfHeight_m;
    ASSERT_TRUE(driver->trigger("part.zoom"));
    EXPECT_LT(driver->window().view().camera().halfHeight_m, 0.6 * reach);
    ASSERT_TRUE(driver->trigger("part.remove"));
    EXPECT_TRUE(driver->scene().objects.empty());
    EXPECT_FALSE(driver->enabled("part.remove"));
    ASSERT_TRUE(driver->trigger("edit.undo"));
    EXPECT_EQ(driver->scene().objects.size(), 1U);
}

TEST_F(CleanWindow, UndoWhileThePointsAreBeingTakenOutLeavesNothingBehind) {
    start(false, true);
    const std::size_t all = points();
    boxRound(-1.15, -0.65, 1.15, 0.65);
    for (int round = 0; round < 3; ++round) {
        ASSERT_TRUE(driver->trigger(round == 0 ? "clean.remove" : "edit.redo"));
        EXPECT_FALSE(driver->window().view().pickAt(at(0, 0, 0.8))) << "hidden at once";
        ASSERT_TRUE(driver->trigger("edit.undo"));
        EXPECT_TRUE(driver->window().view().pickAt(at(0, 0, 0.8))) << "back at once";
    }
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(points(), all);
    EXPECT_FALSE(layer().data->uncleaned);
    ASSERT_TRUE(driver->trigger("edit.redo"));
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(points() + layer().cleaning->removed.size(), all);
}

TEST_F(CleanWindow, ACleanedCaseGivesTheSameWithoutAWindowAndItsFilesStayAsTheyAre) {
    const auto before = readTextFile(scans.target);
    start(true);
    // Something to measure, one end on what is taken out afterwards.
    driver->trigger("tool.distance");
    for (int i = 0; i < 2; ++i) {
        driver->clickOn(test::kBoxCorner);
        driver->clickOn(test::kBoxCornerAlongX);
        if (QWidget* focus = QApplication::focusWidget()) QTest::keyClick(focus, Qt::Key_Return);
    }
    ASSERT_EQ(driver->scene().measurements.size(), 1U);
    const auto u = driver->window().document().measured().lengths[0].length->standardUncertainty_m;
    boxRound(-1.15, -0.65, 1.15, 0.65);
    driver->trigger("clean.remove");
    ASSERT_TRUE(driver->settle());
    EXPECT_EQ(driver->window().document().measured().lengths[0].length->standardUncertainty_m, u)
        << "a pick is as certain as the cloud that it was made on";
    boxRound(2, 2, 4, 4);
    driver->trigger("clean.make-object");
    ASSERT_TRUE(driver->settle());
    driver->answers().casePath = QString::fromStdString((folder / "case.json").string());
    ASSERT_TRUE(driver->trigger("file.save-as"));
    driver->answers().folder = QString::fromStdString((folder / "window").string());
    ASSERT_TRUE(driver->trigger("export.report"));
    ASSERT_TRUE(driver->settle());
    const auto scene = readCase(folder / "case.json");
    ASSERT_TRUE(scene) << scene.error().sentence();
    SceneState bare = *scene;
    bare.file = folder / "case.json";
    const auto alone = reconstruct(bare, folder / "alone", nullptr, nullptr, {});
    ASSERT_TRUE(alone) << alone.error().sentence();
    for (const char* name : {"fused.las", "measurements.csv", "registration.json", "accuracy.csv"}) {
        const auto one = readTextFile(folder / "window" / name);
        const auto other = readTextFile(folder / "alone" / name);
        ASSERT_TRUE(one && other) << name;
        EXPECT_EQ(*one, *other) << name;
    }
    EXPECT_EQ(*readTextFile(scans.target), *before);

    // Opened again it is cleaned.
    const std::size_t left = points();
    driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
        offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::make_unique<InlineJobRunner>()));
    ASSERT_TRUE(driver->window().openCase(folder / "case.json"));
    EXPECT_EQ(points(), left);
    EXPECT_EQ(driver->scene().objects.size(), 2U) << "one of each layer that was shown";
    EXPECT_FALSE(driver->window().document().modified());
    // Of another file, the cleaning is refused.
    driver.reset();
    std::ofstream(scans.target, std::ios::app) << "0 0 0\n";
    driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
        offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::make_unique<InlineJobRunner>()));
    static_cast<void>(driver->window().openCase(folder / "case.json"));
    ASSERT_TRUE(layer().data);
    EXPECT_FALSE(layer().data->uncleaned);
    const auto refused = reconstruct(bare, folder / "refused", nullptr, nullptr, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::input);
    EXPECT_NE(refused.error().message.find("belong to another file"), std::string::npos);
}

}  // namespace
}  // namespace vestige
