#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QSettings>
#include <QSlider>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>

#include "app/offscreen/OffscreenApplication.h"
#include "core/scene/PickFrame.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/jobs/ThreadedJobRunner.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// The yard and its second scan, opened; what the window shows of their registration.
class FitWindow : public testing::Test {
  public:
    FitWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        scans = test::writeSampleScans(folder.path());
    }

    void start(std::unique_ptr<JobRunner> jobs, const std::filesystem::path& source) {
        driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::move(jobs)));
        static_cast<void>(driver->window().openFiles({scans.target, source}));
        ASSERT_TRUE(driver->settle());
        ASSERT_EQ(driver->scene().layers.size(), 2u);
    }
    void startInline() { start(std::make_unique<InlineJobRunner>(), scans.source); }

    const ViewLayer& shown(std::size_t layer) { return driver->window().view().description().layers[layer]; }
    QAction& action(const char* id) { return *driver->window().findChild<QAction*>(id); }
    template <class Widget>
    Widget& widget(const char* name) {
        return *driver->window().findChild<Widget*>(name);
    }
    void key(int key) {
        QTest::keyClick(driver->window().view().widget(), static_cast<Qt::Key>(key));
        QApplication::processEvents();
    }
    QPoint place(double x, double y) {
        const QSize size = driver->window().view().widget()->size();
        return {static_cast<int>(x * size.width()), static_cast<int>(y * size.height())};
    }
    void drag(const QPoint& from, const QPoint& to) {
        QWidget* view = driver->window().view().widget();
        QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, from);
        for (const double share : {0.5, 1.0}) {
            const QPointF at = from + share * QPointF(to - from);
            QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at.toPoint()), Qt::NoButton,
                             Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(view, &move);
        }
        QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, to);
        QApplication::processEvents();
    }

    test::TemporaryFolder folder;
    test::SampleScans scans;
    std::unique_ptr<test::WindowDriver> driver;
};

TEST_F(FitWindow, AnUnwatchedRegistrationKeepsNoSteps) {
    startInline();
    EXPECT_FALSE(action("register.watch").isChecked());
    ASSERT_TRUE(driver->trigger("register.run"));
    ASSERT_TRUE(driver->trigger("view.panel-fit"));
    EXPECT_TRUE(widget<QWidget>("verdict").isVisible());
    EXPECT_EQ(driver->label("verdict-word"), "Accepted");
    EXPECT_FALSE(widget<QSlider>("fit-slider").isVisible());
}

TEST_F(FitWindow, AWatchedRegistrationMovesInTheViewAndIsReplayed) {
    start(std::make_unique<ThreadedJobRunner>(), scans.source);
    ASSERT_TRUE(driver->trigger("register.watch"));
    ASSERT_TRUE(driver->trigger("register.run"));
    ASSERT_TRUE(driver->settle());
    ASSERT_TRUE(driver->scene().layer("second-scan")->registration);
    const RegistrationResult& result = *driver->scene().layer("second-scan")->registration;
    auto& slider = widget<QSlider>("fit-slider");
    ASSERT_TRUE(slider.isVisible()) << "the panel with the steps comes up by itself";
    EXPECT_EQ(slider.maximum() + 1, result.iterations + static_cast<int>(result.voxelSchedule_m.size()))
        << "every iteration, and the start of every size";
    const auto& place = shown(1).worldFromLayer.pose;
    EXPECT_LT((place.matrix() - result.targetFromSource.pose.matrix()).norm(), 1e-12);
    slider.setValue(0);
    QApplication::processEvents();
    EXPECT_LT((shown(1).worldFromLayer.pose.matrix() - result.initial.pose.matrix()).norm(), 1e-9)
        << "the first step is the first pose";
    EXPECT_TRUE(driver->label("preview-words").contains("Replay"));
    EXPECT_TRUE(driver->label("fit-step").contains("start of this size"));
    ASSERT_TRUE(driver->trigger("compare.end"));
    EXPECT_LT((shown(1).worldFromLayer.pose.matrix() - result.targetFromSource.pose.matrix()).norm(), 1e-12);
    EXPECT_FALSE(driver->enabled("compare.end"));
    key(Qt::Key_Comma);
    key(Qt::Key_Comma);
    EXPECT_EQ(slider.value(), slider.maximum() - 2);
    key(Qt::Key_Period);
    EXPECT_EQ(slider.value(), slider.maximum() - 1);
    QTest::mouseClick(&widget<QWidget>("fit-replay"), Qt::LeftButton);
    EXPECT_EQ(slider.value(), 0);
    for (int i = 0; i < 400 && slider.value() < slider.maximum(); ++i) QTest::qWait(20);
    EXPECT_EQ(slider.value(), slider.maximum());
}

TEST_F(FitWindow, WatchingDoesNotChangeTheResult) {
    startInline();
    ASSERT_TRUE(driver->trigger("register.run"));
    const Similarity unwatched = driver->scene().layer("second-scan")->registration->targetFromSource;
    ASSERT_TRUE(driver->trigger("edit.undo"));
    ASSERT_TRUE(driver->trigger("register.watch"));
    ASSERT_TRUE(driver->trigger("register.run"));
    const Similarity watched = driver->scene().layer("second-scan")->registration->targetFromSource;
    EXPECT_EQ(watched.pose.matrix(), unwatched.pose.matrix());
}

TEST_F(FitWindow, TheDividerIsDraggedAndEscapeEndsTheComparison) {
    startInline();
    ASSERT_TRUE(driver->trigger("register.run"));
    ASSERT_TRUE(driver->trigger("compare.swipe"));
    const auto& comparison = driver->window().view().description().comparison;
    ASSERT_TRUE(comparison);
    EXPECT_EQ(comparison->mode, CompareMode::swipe);
    ASSERT_TRUE(shown(1).other) << "the registered layer stands elsewhere in the picture before";
    EXPECT_FALSE(shown(0).other) << "the target does not";
    const ViewCamera camera = driver->window().view().camera();
    drag(place(0.5, 0.7), place(0.25, 0.7));
    EXPECT_NEAR(comparison->divider, 0.25, 0.01);
    EXPECT_EQ(driver->window().view().camera().position, camera.position) << "the view does not turn with it";
    drag(place(0.7, 0.7), place(0.6, 0.6));
    EXPECT_NE(driver->window().view().camera().position, camera.position) << "beside it the view turns";
    key(Qt::Key_Right);
    EXPECT_NEAR(comparison->divider, 0.27, 0.01);
    key(Qt::Key_Escape);
    EXPECT_FALSE(comparison);
    EXPECT_FALSE(action("compare.swipe").isChecked());
}

TEST_F(FitWindow, OneComparisonTakesTheOthersPlace) {
    startInline();
    ASSERT_TRUE(driver->trigger("register.run"));
    const auto& comparison = driver->window().view().description().comparison;
    key(Qt::Key_C);
    ASSERT_TRUE(comparison);
    EXPECT_EQ(comparison->mode, CompareMode::checkerboard);
    EXPECT_EQ(driver->label("compare-amount"), "96 pixels");
    key(Qt::Key_Left);
    EXPECT_EQ(comparison->tile_px, 64);
    widget<QSlider>("compare-slider").setValue(0);
    EXPECT_EQ(comparison->tile_px, 24);
    key(Qt::Key_K);
    EXPECT_EQ(comparison->mode, CompareMode::blink);
    EXPECT_FALSE(action("compare.checkerboard").isChecked());
    key(Qt::Key_Space);
    EXPECT_EQ(driver->label("compare-amount"), "held");
    EXPECT_TRUE(comparison->otherShown);
    ASSERT_TRUE(driver->trigger("compare.layers"));
    EXPECT_EQ(comparison->otherName, "Target");
    EXPECT_FALSE(shown(0).visible);
    EXPECT_TRUE(shown(0).other->visible);
    EXPECT_FALSE(shown(1).other->visible);
    key(Qt::Key_K);
    EXPECT_FALSE(comparison);
    EXPECT_TRUE(shown(0).visible);
}

TEST_F(FitWindow, ALayerThatFailedStaysAndIsPreviewed) {
    const std::filesystem::path ball = test::writeBall(folder.path());
    start(std::make_unique<InlineJobRunner>(), ball);
    ASSERT_TRUE(driver->trigger("register.run"));
    EXPECT_FALSE(driver->scene().layer("ball")->registration);
    EXPECT_FALSE(isPlaced(driver->scene(), *driver->scene().layer("ball")));
    EXPECT_EQ(driver->label("verdict-word"), "Failed");
    EXPECT_FALSE(driver->label("reasons").isEmpty());
    const Similarity stays = shown(1).worldFromLayer;
    ASSERT_TRUE(driver->trigger("register.preview"));
    EXPECT_NE(shown(1).worldFromLayer.pose.matrix(), stays.pose.matrix());
    EXPECT_TRUE(driver->label("preview-words").contains("not moved"));
    EXPECT_FALSE(driver->scene().layer("ball")->registration);
    key(Qt::Key_Escape);
    EXPECT_EQ(shown(1).worldFromLayer.pose.matrix(), stays.pose.matrix());
    EXPECT_FALSE(action("register.preview").isChecked());
    EXPECT_FALSE(driver->textOf("edit.undo").contains("register"));
}

TEST_F(FitWindow, TheSourceOfAComparisonIsWhatWasRegistered) {
    const std::filesystem::path other = test::writeBall(folder.path());
    startInline();
    ASSERT_TRUE(driver->window().openFiles({other}));
    ASSERT_TRUE(driver->settle());
    widget<QTreeWidget>("layers").setCurrentItem(widget<QTreeWidget>("layers").topLevelItem(1));
    ASSERT_TRUE(driver->trigger("register.run"));
    ASSERT_TRUE(driver->scene().layer("second-scan")->registration);
    key(Qt::Key_C);
    ASSERT_TRUE(driver->trigger("compare.layers"));
    EXPECT_TRUE(shown(1).visible);
    EXPECT_FALSE(shown(2).visible) << "a layer that lies somewhere would only hide what is compared";
    EXPECT_FALSE(shown(2).other->visible);
}

TEST_F(FitWindow, DistancesAreSignedAndTheLegendKeepsClearOfTheTools) {
    startInline();
    ASSERT_TRUE(driver->trigger("register.run"));
    ASSERT_TRUE(driver->trigger("register.residual"));
    QApplication::processEvents();
    const auto& distances = shown(1).residual_m;
    ASSERT_TRUE(distances);
    const auto below = std::count_if(distances->begin(), distances->end(), [](float d) { return d < 0; });
    const auto above = std::count_if(distances->begin(), distances->end(), [](float d) { return d > 0; });
    EXPECT_GT(below, 100);
    EXPECT_GT(above, 100);
    EXPECT_TRUE(driver->window().view().description().title.empty()) << "it would lie under the tools";
    const QImage picture = driver->window().view().grab();
    const QRect tools = widget<QWidget>("tool-palette").geometry();
    // The legend's bar runs from blue to orange: below the tools at the right.
    int blue = 0;
    int orange = 0;
    for (int y = tools.bottom() + 1; y < picture.height() / 2; ++y)
        for (int x = picture.width() - 250; x < picture.width(); ++x) {
            const QColor color = picture.pixelColor(x, y);
            blue += color.blue() > 180 && color.red() < 60;
            orange += color.red() > 200 && color.blue() < 60;
        }
    EXPECT_GT(blue, 20);
    EXPECT_GT(orange, 20);
}

TEST_F(FitWindow, PanelsHaveKeys) {
    startInline();
    auto& tabs = widget<QTabWidget>("right");
    for (const auto& [id, index] : {std::pair("view.panel-fit", 2), std::pair("view.panel-measure", 0),
                                    std::pair("view.panel-align", 1)}) {
        ASSERT_TRUE(driver->trigger(id));
        EXPECT_EQ(tabs.currentIndex(), index) << id;
    }
}

}  // namespace
}  // namespace vestige
