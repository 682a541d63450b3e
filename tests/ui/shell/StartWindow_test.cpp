#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QTabWidget>
#include <QTableView>
#include <QTreeWidget>
#include <fstream>

#include "core/scene/CaseFile.h"
#include "tests/ui/shell/ShellFixture.h"
#include "ui/document/Document.h"
#include "ui/document/RecentFiles.h"
#include "ui/document/SampleCase.h"
#include "ui/shell/StepButton.h"
#include "ui/shell/WindowPlace.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

class StartWindow : public test::ShellWindow {
  public:
    StepButton& step(WayStep which) {
        return widget<StepButton>(("step-" + std::to_string(static_cast<int>(which))).c_str());
    }
    bool visible(const char* name) { return widget<QWidget>(name).isVisible(); }
    QLineEdit& field(const char* name) {
        for (auto* line : driver->window().findChildren<QLineEdit*>(name))
            if (line->isVisible()) return *line;
        throw std::runtime_error(std::string("no visible field ") + name);
    }
};

TEST_F(StartWindow, TheStartPageHasTheWindowToItself) {
    start();
    EXPECT_TRUE(visible("welcome"));
    EXPECT_FALSE(visible("step-bar"));
    EXPECT_FALSE(visible("right"));
    EXPECT_FALSE(visible("layers"));
    ASSERT_TRUE(driver->window().openFiles({scans.target}));
    EXPECT_FALSE(visible("welcome"));
    EXPECT_TRUE(visible("step-bar"));
    EXPECT_TRUE(visible("right"));
    EXPECT_TRUE(visible("layers"));
}

TEST_F(StartWindow, ANewCaseCanBeNamedBeforeItHasScans) {
    start();
    ASSERT_TRUE(driver->trigger("file.new"));
    EXPECT_FALSE(visible("welcome"));
    ASSERT_TRUE(visible("empty-case"));
    QTest::keyClicks(&field("case-name"), "Crossing");
    QTest::keyClick(&field("case-name"), Qt::Key_Return);
    QTest::keyClicks(&field("case-operator"), "A. Analyst");
    QTest::keyClick(&field("case-operator"), Qt::Key_Return);
    EXPECT_EQ(driver->scene().name, "Crossing");
    EXPECT_EQ(driver->scene().operatorName, "A. Analyst");
    EXPECT_TRUE(visible("empty-case"));
}

TEST_F(StartWindow, RecentCasesAreListedAndMissingOnesMarked) {
    RecentFiles recent;
    recent.add(path("gone.json"));
    recent.add(QString::fromStdString(scans.target.string()));
    start();
    auto& list = widget<QTreeWidget>("recent");
    ASSERT_EQ(list.topLevelItemCount(), 2);
    EXPECT_EQ(list.topLevelItem(0)->text(0), "yard");
    EXPECT_TRUE(list.topLevelItem(0)->text(2).startsWith("today"))
        << list.topLevelItem(0)->text(2).toStdString();
    EXPECT_EQ(list.topLevelItem(1)->text(2), "not found");
    const auto click = [&](int row) {
        QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier,
                          list.visualItemRect(list.topLevelItem(row)).center());
        QApplication::processEvents();
    };
    click(1);
    EXPECT_EQ(list.topLevelItemCount(), 1) << "what is gone is taken off the list";
    EXPECT_TRUE(driver->scene().layers.empty());
    click(0);
    EXPECT_EQ(driver->scene().layers.size(), 1u);
}

TEST_F(StartWindow, TheSampleIsOpenedWhereItIs) {
    QDir().mkpath(sampleFolder());
    std::ofstream(sampleFolder().toStdString() + "/case.json")
        << R"({"vestige": 1, "name": "Sample", "layers": [{"id": "yard", "role": "aerial", "path": ")"
        << scans.target.string() << R"("}]})";
    start();
    std::ofstream(sampleMark(sampleFolder()).toStdString()) << "";
    EXPECT_EQ(sampleCase(), sampleFolder() + "/case.json");
    ASSERT_TRUE(driver->trigger("file.sample"));
    EXPECT_EQ(driver->scene().name, "Sample");
}

TEST_F(StartWindow, TheStepsSayWhatIsMissingAndGoThere) {
    startLoaded();
    EXPECT_TRUE(step(WayStep::import).accessibleName().contains("done"));
    EXPECT_EQ(step(WayStep::align).accessibleDescription(), "second scan is not registered");
    auto& tabs = widget<QTabWidget>("right");
    for (const auto& [which, panel] :
         {std::pair(WayStep::import, 3), std::pair(WayStep::align, 1), std::pair(WayStep::clean, 4),
          std::pair(WayStep::report, 5), std::pair(WayStep::measure, 0)}) {
        QTest::mouseClick(&step(which), Qt::LeftButton);
        EXPECT_EQ(tabs.currentIndex(), panel);
        QTest::keyClick(&step(which), Qt::Key_Space);
        EXPECT_EQ(tabs.currentIndex(), panel);
    }
    ASSERT_TRUE(driver->trigger("register.run"));
    EXPECT_TRUE(step(WayStep::align).accessibleName().contains("done"));
    pickBox(2);
    EXPECT_TRUE(step(WayStep::measure).accessibleDescription().contains("fewer than 3 repeats"));
    pickBox(1);
    EXPECT_TRUE(step(WayStep::measure).accessibleName().contains("done"));
    EXPECT_TRUE(step(WayStep::report).accessibleDescription().contains("has no tape value"));
}

TEST_F(StartWindow, TheFitStandsBesideTheRegistration) {
    startLoaded();
    auto& tabs = widget<QTabWidget>("right");
    ASSERT_TRUE(driver->trigger("view.panel-fit"));
    EXPECT_TRUE(tabs.isTabVisible(1));
    EXPECT_TRUE(tabs.isTabVisible(2));
    EXPECT_FALSE(tabs.isTabVisible(0));
    QTest::mouseClick(&step(WayStep::measure), Qt::LeftButton);
    QTest::mouseClick(&step(WayStep::align), Qt::LeftButton);
    EXPECT_EQ(tabs.currentIndex(), 2) << "where the user was in that step";
}

TEST_F(StartWindow, TheReportPanelTakesTheCasesDetailsAndListsWhatWasWritten) {
    startLoaded();
    ASSERT_TRUE(driver->trigger("register.run"));
    pickBox(3);
    ASSERT_TRUE(driver->trigger("view.panel-report"));
    QTest::keyClicks(&field("case-operator"), "B. Analyst");
    QTest::keyClick(&field("case-operator"), Qt::Key_Return);
    EXPECT_EQ(driver->scene().operatorName, "B. Analyst");
    QTest::keyClicks(&field("case-latitude"), "30.6");
    QTest::keyClick(&field("case-latitude"), Qt::Key_Return);
    EXPECT_FALSE(driver->scene().site) << "half a place is none";
    QTest::keyClicks(&field("case-longitude"), "114.3");
    QTest::keyClick(&field("case-longitude"), Qt::Key_Return);
    ASSERT_TRUE(driver->scene().site);
    EXPECT_EQ(driver->scene().site->longitude_deg, 114.3);
    EXPECT_EQ(field("case-latitude").text(), "30.6");
    driver->answers().csv = path("lengths.csv");
    ASSERT_TRUE(driver->trigger("export.csv"));
    auto& outputs = widget<QTreeWidget>("outputs");
    ASSERT_EQ(outputs.topLevelItemCount(), 1);
    EXPECT_EQ(outputs.topLevelItem(0)->text(0), "lengths.csv");
}

TEST_F(StartWindow, ACaseOpensAtWhatIsToBeDoneNext) {
    startLoaded();
    driver->answers().casePath = path("night.vestige");
    ASSERT_TRUE(driver->trigger("file.save-as"));
    const auto shown = [&](WayStep which) { return step(which).isShown(); };
    start();
    ASSERT_TRUE(driver->window().openCase(path("night.vestige").toStdString()));
    EXPECT_TRUE(shown(WayStep::align));
    ASSERT_TRUE(driver->trigger("register.run"));
    ASSERT_TRUE(driver->trigger("file.save"));
    start();
    ASSERT_TRUE(driver->window().openCase(path("night.vestige").toStdString()));
    EXPECT_TRUE(shown(WayStep::measure));
}

TEST_F(StartWindow, TheViewGoesToTheSelectedObject) {
    startLoaded();
    ASSERT_TRUE(driver->trigger("register.run"));
    pickBox(3);
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    widget<QTableView>("measurements").selectRow(0);
    ASSERT_TRUE(driver->trigger("view.top"));
    const ViewCamera far = driver->window().view().camera();
    ASSERT_TRUE(driver->trigger("view.object"));
    const ViewCamera near = driver->window().view().camera();
    const auto middle = near.project(0.5 * (test::kBoxCorner + test::kBoxCornerAlongX));
    ASSERT_TRUE(middle);
    EXPECT_LT((near.position - near.focalPoint).norm(), (far.position - far.focalPoint).norm());
    EXPECT_NEAR(middle->pixel.x(), 0.5 * near.width_px, 0.05 * near.width_px);
    EXPECT_NEAR(middle->pixel.y(), 0.5 * near.height_px, 0.05 * near.height_px);
}

TEST_F(StartWindow, ASmallScreenIsFilledAndTheWindowComesBackWhereItWas) {
    start();
    QMainWindow& window = driver->window();
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    window.resize(screen.width() + 200, 700);
    placeWindow(window);
    EXPECT_TRUE(window.isMaximized());
    window.showNormal();
    window.setGeometry(20, 30, 1300, 700);
    keepPlace(window);
    start();
    placeWindow(driver->window());
    EXPECT_EQ(driver->window().width(), 1300);
    EXPECT_FALSE(driver->window().isMaximized());
}

}  // namespace
}  // namespace vestige
