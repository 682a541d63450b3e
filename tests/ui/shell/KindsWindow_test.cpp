#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>
#include <fstream>

#include "app/offscreen/OffscreenApplication.h"
#include "core/measurement/kinds/KindSpec.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/actions/KindTools.h"
#include "ui/document/Document.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/print/PdfPrinter.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// Upper corners of the sample's box, and points of the ground beside it.
const Eigen::Vector3d kA{-1, -0.5, 0.8}, kB{1, -0.5, 0.8}, kC{1, 0.5, 0.8}, kD{-1, 0.5, 0.8};

class KindsWindow : public testing::Test {
  public:
    KindsWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        const auto scans = test::writeSampleScans(folder.path());
        driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), std::make_unique<PdfPrinter>(), nullptr,
            std::make_unique<InlineJobRunner>()));
        EXPECT_TRUE(driver->window().openFiles({scans.target}));
        driver->window().showNamedView(NamedView::top);
    }
    QWidget* view() { return driver->window().view().widget(); }
    void key(Qt::Key key) {
        QTest::keyClick(view(), key);
        QApplication::processEvents();
    }
    /// The ground where it is seen from above, outside of the box; on the scan's own grid.
    static Eigen::Vector3d ground(double x, double y) { return {x, y, 0}; }
    /// A new object's name is being edited after its first repeat.
    void leaveName() {
        if (QWidget* focus = QApplication::focusWidget()) QTest::keyClick(focus, Qt::Key_Return);
        view()->setFocus();
        QApplication::processEvents();
    }
    void click(const std::vector<Eigen::Vector3d>& points) {
        for (const auto& point : points) driver->clickOn(point);
    }
    const Measurement& last() { return driver->scene().measurements.back(); }
    const MeasuredKind& figures() { return driver->window().document().measured().kinds.back(); }

    test::TemporaryFolder folder;
    std::unique_ptr<test::WindowDriver> driver;
};

TEST_F(KindsWindow, EveryToolMakesAnObjectOfItsKindInOneStep) {
    const std::vector<Eigen::Vector3d> points{
        kA, kB, kC, kD, ground(2, 2), ground(3, -2), ground(2.5, -3), ground(-2, -3)};
    for (const auto& [id, kind] : kindTools()) {
        const KindSpec& spec = kindSpec(kind);
        ASSERT_TRUE(driver->trigger(id)) << id;
        EXPECT_TRUE(driver->window().findChild<QAction*>(id)->isChecked()) << id;
        const std::size_t before = driver->scene().measurements.size();
        std::vector<Eigen::Vector3d> picked(points.begin(),
                                            points.begin() + static_cast<std::ptrdiff_t>(spec.fewest));
        if (kind == MeasurementKind::arc) picked = {kA, ground(2.5, -3), kC};
        if (kind == MeasurementKind::planeToPlane)
            picked = {kA, kB, kC, ground(2, 2), ground(3, -2), ground(-2, -3)};
        click(picked);
        if (spec.most == 0) {
            EXPECT_EQ(driver->scene().measurements.size(), before) << id << " is not ended yet";
            key(Qt::Key_Return);
        }
        ASSERT_EQ(driver->scene().measurements.size(), before + 1) << id;
        EXPECT_EQ(last().kind, kind) << id;
        EXPECT_EQ(last().picks.size() + last().paths.size(), 1u) << id;
        ASSERT_FALSE(figures().quantities.empty()) << id << ": " << figures().note;
        leaveName();
        EXPECT_TRUE(driver->trigger("edit.undo"));
        EXPECT_EQ(driver->scene().measurements.size(), before) << id;
        EXPECT_TRUE(driver->trigger("edit.redo"));
    }
    // 0.8 m: the box stands on the ground.
    for (const MeasuredKind& kind : driver->window().document().measured().kinds)
        if (kind.kind == MeasurementKind::planeToPlane) {
            EXPECT_NEAR(kind.quantities.front().mean, 0.8, 0.01);
        }
}

TEST_F(KindsWindow, BackspaceTakesAPointBackAndEscapeGivesUp) {
    driver->trigger("tool.polyline");
    EXPECT_TRUE(driver->label("hint").contains("click the start")) << driver->label("hint").toStdString();
    click({kA, kB, ground(3, -2)});
    EXPECT_TRUE(driver->label("hint").contains("Enter ends")) << driver->label("hint").toStdString();
    key(Qt::Key_Backspace);
    driver->clickOn(kC);
    key(Qt::Key_Return);
    leaveName();
    ASSERT_EQ(last().paths.at("yard").size(), 1u);
    ASSERT_EQ(last().paths.at("yard")[0].size(), 3u);
    EXPECT_NEAR(figures().quantities.front().mean, 3, 0.06);
    // A second repeat goes to the same object; with none begun Backspace takes that away.
    click({kA, kB, kC});
    key(Qt::Key_Enter);
    EXPECT_EQ(driver->scene().measurements.size(), 1u);
    EXPECT_EQ(last().paths.at("yard").size(), 2u);
    EXPECT_TRUE(driver->trigger("object.remove-pick"));
    EXPECT_EQ(last().paths.at("yard").size(), 1u);
    click({kA, kB});
    key(Qt::Key_Escape);
    key(Qt::Key_Return);
    EXPECT_EQ(last().paths.at("yard").size(), 1u);
}

TEST_F(KindsWindow, ADoubleClickAndTheRightButtonEndAPath) {
    driver->trigger("tool.polyline");
    driver->clickOn(kA);
    const auto at = [&](const Eigen::Vector3d& world) {
        const auto shown = driver->window().view().camera().project(world);
        return QPoint(static_cast<int>(shown->pixel.x()), static_cast<int>(shown->pixel.y()));
    };
    QTest::mouseClick(view(), Qt::RightButton, Qt::NoModifier, at(kB));
    EXPECT_TRUE(driver->scene().measurements.empty()) << "one point is no line";
    QTest::mouseClick(view(), Qt::LeftButton, Qt::NoModifier, at(kB));
    // As the X server sends it: press, release, double click, release.
    QTest::mouseClick(view(), Qt::LeftButton, Qt::NoModifier, at(kC));
    QTest::mouseDClick(view(), Qt::LeftButton, Qt::NoModifier, at(kC));
    QApplication::processEvents();
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    ASSERT_EQ(last().paths.at("yard")[0].size(), 3u);
    leaveName();
    click({kA, kB});
    QTest::mouseClick(view(), Qt::RightButton, Qt::NoModifier, at(kD));
    EXPECT_EQ(last().paths.at("yard").size(), 2u);
    QTest::mouseClick(view(), Qt::LeftButton, Qt::AltModifier, at(kA));
    key(Qt::Key_Return);
    EXPECT_EQ(last().paths.at("yard").size(), 2u) << "with Alt no press is a click";
}

TEST_F(KindsWindow, FiguresUnfoldIntoTheirBudget) {
    driver->trigger("tool.angle");
    for (int repeat = 0; repeat < 3; ++repeat) {
        click({kA, kB, kC});
        leaveName();
    }
    ASSERT_TRUE(driver->trigger("view.panel-object"));
    auto* tree = driver->window().findChild<QTreeWidget*>("figures");
    ASSERT_TRUE(tree && tree->isVisible());
    ASSERT_EQ(tree->topLevelItemCount(), 2);
    EXPECT_EQ(tree->topLevelItem(0)->text(0), "Angle");
    EXPECT_TRUE(tree->topLevelItem(0)->text(1).endsWith(QString::fromUtf8("°")));
    ASSERT_EQ(tree->topLevelItem(0)->childCount(), 3);
    EXPECT_EQ(tree->topLevelItem(0)->child(0)->text(0), "repeats");
    EXPECT_EQ(tree->topLevelItem(0)->child(1)->text(0), "sensor noise");
    tree->topLevelItem(0)->setExpanded(true);
    click({kA, kB, kC});
    EXPECT_TRUE(tree->topLevelItem(0)->isExpanded()) << "stays unfolded when a repeat comes";
    // What the reference is, typed where a tape would be.
    ASSERT_TRUE(driver->trigger("view.panel-measure"));
    driver->typeInto(0, 1, "80");
    EXPECT_EQ(last().settings.at("reference_deg"), 80);
    EXPECT_NEAR(figures().quantities.front().relativeError.value_or(0), 0.125, 0.02);
}

TEST_F(KindsWindow, TheKindAndItsParametersAreChangedInPlace) {
    driver->trigger("tool.polyline");
    click({ground(2, 2), ground(3, 0), ground(3, -2), ground(2.5, -3)});
    key(Qt::Key_Return);
    leaveName();
    ASSERT_TRUE(driver->trigger("view.panel-object"));
    auto* kinds = driver->window().findChild<QComboBox*>("kind");
    ASSERT_TRUE(kinds && kinds->isVisible());
    const int arc = kinds->findText("Arc (yaw mark)");
    ASSERT_GE(arc, 0);
    kinds->setCurrentIndex(arc);
    emit kinds->activated(arc);
    EXPECT_EQ(last().kind, MeasurementKind::arc);
    EXPECT_EQ(figures().find("speed_fit"), nullptr);
    auto* drag = driver->window().findChild<QWidget*>("drag_factor");
    ASSERT_TRUE(drag && drag->isVisible());
    auto* field = drag->findChild<QLineEdit*>();
    if (!field) field = qobject_cast<QLineEdit*>(drag);
    ASSERT_TRUE(field);
    field->selectAll();
    QTest::keyClicks(field, "0.7");
    QTest::keyClick(field, Qt::Key_Return);
    QApplication::processEvents();
    EXPECT_EQ(last().settings.at("drag_factor"), 0.7);
    EXPECT_NE(figures().find("speed_fit"), nullptr);
    EXPECT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->trigger("edit.undo"));
    EXPECT_EQ(last().kind, MeasurementKind::polyline);
}

TEST_F(KindsWindow, VerifiedIsSaidOnlyOfAKnownDistanceThatAgrees) {
    driver->trigger("tool.distance");
    for (int repeat = 0; repeat < 2; ++repeat) {
        click({kA, kB});
        leaveName();
    }
    EXPECT_TRUE(driver->label("verification").startsWith("Not verified"));
    driver->typeInto(0, 1, "2.00");
    ASSERT_TRUE(driver->trigger("measure.check"));
    EXPECT_TRUE(last().checkTolerance_m);
    auto* tolerance = driver->window().findChild<QLineEdit*>("check-tolerance");
    ASSERT_TRUE(tolerance && tolerance->isEnabled());
    tolerance->setText("0,1");
    QTest::keyClick(tolerance, Qt::Key_Return);
    EXPECT_EQ(last().checkTolerance_m, 0.1);
    EXPECT_TRUE(driver->label("verification").startsWith("Verified"))
        << driver->label("verification").toStdString();
    driver->typeInto(0, 1, "2.40");
    EXPECT_TRUE(driver->label("verification").startsWith("CHECK FAILED"))
        << driver->label("verification").toStdString();
    ASSERT_TRUE(driver->trigger("measure.check"));
    EXPECT_FALSE(last().checkTolerance_m);
    EXPECT_TRUE(driver->label("verification").startsWith("Not verified"));
    EXPECT_TRUE(driver->trigger("edit.undo"));
    EXPECT_EQ(last().checkTolerance_m, 0.1);
    EXPECT_TRUE(driver->window().findChild<QAction*>("measure.check")->isChecked());
}

/// Keeps jobs until it is told to run them.
class HeldJobRunner : public JobRunner {
  public:
    bool busy() const override { return !held_.empty(); }
    void cancel() override { control_.cancel(); }
    std::size_t held() const { return held_.size(); }
    bool holds = false;

    void runHeld() {
        while (!held_.empty()) {
            const Job job = std::move(held_.front());
            held_.erase(held_.begin());
            begin(job);
        }
    }

  protected:
    void enqueue(Job job) override {
        if (holds)
            held_.push_back(std::move(job));
        else
            begin(job);
    }
    void post(std::function<void()> task) override { task(); }

  private:
    void begin(const Job& job) {
        emit started(job.title);
        const auto deliver = job.work(control_);
        deliver();
        emit finished(job.title);
        control_ = JobControl();
    }

    std::vector<Job> held_;
    JobControl control_;
};

class LaterKindsWindow : public KindsWindow {
  public:
    LaterKindsWindow() {
        const auto scans = test::writeSampleScans(folder.path());
        auto runner = std::make_unique<HeldJobRunner>();
        jobs = runner.get();
        driver = std::make_unique<test::WindowDriver>(
            std::make_unique<MainWindow>(offscreenSurface(), offscreenRenderer(),
                                         std::make_unique<PdfPrinter>(), nullptr, std::move(runner)));
        EXPECT_TRUE(driver->window().openFiles({scans.target}));
        driver->window().showNamedView(NamedView::top);
        jobs->holds = true;
        driver->trigger("tool.volume");
        click({kA, kB, kC, kD});
        key(Qt::Key_Return);
        leaveName();
        driver->trigger("view.panel-object");
    }
    QString note() { return driver->label("figures-note"); }

    HeldJobRunner* jobs = nullptr;
};

TEST_F(LaterKindsWindow, AVolumeIsComputedByAJobAndThePanelSaysSo) {
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    EXPECT_EQ(jobs->held(), 1u);
    EXPECT_TRUE(figures().quantities.empty());
    EXPECT_EQ(note(), "being computed from the cloud");
    EXPECT_EQ(driver->window().view().description().paths.size(), 1u) << "what was picked is seen meanwhile";
    jobs->runHeld();
    ASSERT_FALSE(figures().quantities.empty());
    EXPECT_EQ(figures().quantities.front().key, "volume");
    EXPECT_FALSE(note().contains("computed"));
    EXPECT_EQ(jobs->held(), 0u);
    driver->trigger("edit.undo");
    driver->trigger("edit.redo");
    EXPECT_EQ(jobs->held(), 0u) << "it is remembered";
}

TEST_F(LaterKindsWindow, WhatWasCancelledIsTakenUpAtTheNextChange) {
    jobs->cancel();
    jobs->runHeld();
    EXPECT_EQ(jobs->held(), 0u);
    EXPECT_EQ(note(), "not computed; the next change of the case takes it up");
    jobs->holds = false;
    click({kA, kB, kC, kD});
    key(Qt::Key_Return);
    ASSERT_FALSE(figures().quantities.empty());
    EXPECT_EQ(figures().quantities.front().repeats.size(), 2u);
}

TEST_F(KindsWindow, TheTablesOfFiguresAndBudgetsAreWrittenBesideTheMeasurements) {
    driver->trigger("tool.angle");
    click({kA, kB, kC});
    leaveName();
    driver->answers().csv = QString::fromStdString((folder / "My measurements.csv").string());
    ASSERT_TRUE(driver->trigger("export.csv"));
    for (const char* name : {"My measurements.csv", "My quantities.csv", "My uncertainty.csv"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    std::ifstream file(folder / "My quantities.csv");
    std::string header, row;
    std::getline(file, header);
    std::getline(file, row);
    EXPECT_TRUE(row.starts_with("Angle 1,")) << row;
    driver->answers().csv = QString::fromStdString((folder / "table.csv").string());
    ASSERT_TRUE(driver->trigger("export.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder / "table uncertainty.csv"));
}

}  // namespace
}  // namespace vestige
