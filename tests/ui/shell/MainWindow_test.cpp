#include "ui/shell/MainWindow.h"

#include <gtest/gtest.h>

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QImage>
#include <QMimeData>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>
#include <fstream>

#include "app/offscreen/OffscreenApplication.h"
#include "core/io/ApplyReadOptions.h"
#include "core/scene/CaseFile.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/document/Document.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/jobs/ThreadedJobRunner.h"
#include "ui/print/PdfPrinter.h"
#include "ui/shell/NoticeBar.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

using test::kBoxCorner;
using test::kBoxCornerAlongX;

class Workstation : public testing::Test {
  public:
    Workstation() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        scans = test::writeSampleScans(folder.path());
    }

    std::unique_ptr<test::WindowDriver> start(std::unique_ptr<JobRunner> jobs) {
        return std::make_unique<test::WindowDriver>(
            std::make_unique<MainWindow>(offscreenSurface(), offscreenRenderer(),
                                         std::make_unique<PdfPrinter>(), nullptr, std::move(jobs)));
    }
    std::unique_ptr<test::WindowDriver> startLoaded(bool both) {
        auto driver = start(std::make_unique<InlineJobRunner>());
        std::vector<std::filesystem::path> files{scans.target};
        if (both) files.push_back(scans.source);
        EXPECT_TRUE(driver->window().openFiles(files));
        return driver;
    }
    void pickBox(test::WindowDriver& driver, int times) {
        driver.trigger("tool.distance");
        for (int i = 0; i < times; ++i) {
            driver.clickOn(kBoxCorner);
            driver.clickOn(kBoxCornerAlongX);
            // A new object's name is being edited now.
            if (QWidget* focus = QApplication::focusWidget()) QTest::keyClick(focus, Qt::Key_Return);
        }
    }

    test::TemporaryFolder folder;
    test::SampleScans scans;
};

TEST_F(Workstation, BeginsEmptyAndSaysWhatToDo) {
    auto driver = start(std::make_unique<InlineJobRunner>());
    EXPECT_TRUE(driver->window().findChild<QWidget*>("welcome")->isVisible());
    EXPECT_FALSE(driver->enabled("register.run"));
    EXPECT_FALSE(driver->enabled("edit.undo"));
    EXPECT_EQ(driver->label("job"), "Ready");
}

TEST_F(Workstation, FilesBecomeLayersInOneStep) {
    auto driver = start(std::make_unique<InlineJobRunner>());
    driver->answers().files = QStringList{QString::fromStdString(scans.target.string()),
                                          QString::fromStdString(scans.source.string())};
    ASSERT_TRUE(driver->trigger("file.add-files"));
    ASSERT_EQ(driver->scene().layers.size(), 2u);
    EXPECT_EQ(driver->scene().target, "yard");
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo add yard, second scan");
    EXPECT_FALSE(driver->window().findChild<QWidget*>("welcome")->isVisible());
    EXPECT_EQ(driver->window().findChild<QTreeWidget*>("layers")->topLevelItemCount(), 2);
    EXPECT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->scene().layers.empty());
    EXPECT_TRUE(driver->trigger("edit.redo"));
    EXPECT_EQ(driver->scene().layers.size(), 2u);
    EXPECT_NE(driver->scene().layers[0].data, nullptr);
}

TEST_F(Workstation, AFileThatCannotBeReadIsToldAndTheOthersAreAdded) {
    std::ofstream(folder / "broken.ply") << "ply\nformat ascii 1.0\nelement vertex 5\n";
    auto driver = start(std::make_unique<InlineJobRunner>());
    const Status opened = driver->window().openFiles({folder / "broken.ply", scans.target});
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::input);
    EXPECT_NE(opened.error().sentence().find("broken.ply"), std::string::npos);
    EXPECT_EQ(driver->scene().layers.size(), 1u);
}

TEST_F(Workstation, OfACutFileItIsOfferedToLoadWhatIsWhole) {
    std::ofstream(folder / "cut.pts") << "3\n1 2 3\n4 5 6\n";
    auto driver = start(std::make_unique<InlineJobRunner>());
    EXPECT_FALSE(driver->window().openFiles({folder / "cut.pts"}));
    EXPECT_TRUE(driver->scene().layers.empty());
    auto* button = driver->window().findChild<QToolButton*>("notice-button");
    ASSERT_TRUE(button && button->isVisible());
    EXPECT_EQ(button->text(), "Load what is whole");
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_EQ(driver->scene().layers.size(), 1u);
    const Layer& layer = driver->scene().layers[0];
    EXPECT_TRUE(layer.salvage) << "the case that is saved opens the same";
    EXPECT_EQ(layer.data->points->size(), 2u);
    EXPECT_NE(layer.data->info.damage.find("the first 2 of 3 points"), std::string::npos);
}

TEST_F(Workstation, OfADamagedLayerOfACaseItIsOfferedToLoadWhatIsWhole) {
    const std::filesystem::path scan = folder / "scan.pts";
    std::ofstream(scan) << "3\n1 2 3\n4 5 6\n7 8 9\n";
    auto driver = start(std::make_unique<InlineJobRunner>());
    EXPECT_TRUE(driver->window().openFiles({scan}));
    driver->answers().casePath = QString::fromStdString((folder / "case.vestige").string());
    ASSERT_TRUE(driver->trigger("file.save"));
    driver.reset();
    std::ofstream(scan) << "3\n1 2 3\n4 5 6\n";
    driver = start(std::make_unique<InlineJobRunner>());
    static_cast<void>(driver->window().openCase(folder / "case.vestige"));
    ASSERT_EQ(driver->scene().layers.size(), 1u);
    EXPECT_FALSE(driver->scene().layers[0].data);
    auto* button = driver->window().findChild<QToolButton*>("notice-button");
    ASSERT_TRUE(button && button->isVisible());
    EXPECT_EQ(button->text(), "Load what is whole");
    QTest::mouseClick(button, Qt::LeftButton);
    const Layer& layer = driver->scene().layers[0];
    EXPECT_TRUE(layer.salvage);
    ASSERT_TRUE(layer.data);
    EXPECT_EQ(layer.data->points->size(), 2u);
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo load what is whole of scan");
    const QString told = driver->window().findChild<NoticeBar*>("notice")->text();
    EXPECT_TRUE(told.contains("is not the file that became part of the case")) << told.toStdString();
    driver->answers().casePath = QString::fromStdString(scan.string());
    const auto before = std::filesystem::file_size(scan);
    driver->trigger("file.save-as");
    EXPECT_EQ(std::filesystem::file_size(scan), before);
}

TEST_F(Workstation, SeveralBadFilesAreAllNamed) {
    std::ofstream(folder / "cut.pts") << "3\n1 2 3\n4 5 6\n";
    std::ofstream(folder / "bad.xyz") << "1 2 3\n4 x\n";
    auto driver = start(std::make_unique<InlineJobRunner>());
    EXPECT_FALSE(driver->window().openFiles({folder / "cut.pts", folder / "bad.xyz", scans.target}));
    EXPECT_EQ(driver->scene().layers.size(), 1u);
    const QString notice = driver->window().findChild<NoticeBar*>("notice")->text();
    EXPECT_TRUE(notice.contains("cut.pts") && notice.contains("bad.xyz")) << notice.toStdString();
    auto* button = driver->window().findChild<QToolButton*>("notice-button");
    ASSERT_TRUE(button && button->isVisible());
    EXPECT_EQ(button->text(), "Load what is whole of cut.pts");
}

TEST_F(Workstation, ACheckBoxHidesALayerAndUndoShowsIt) {
    auto driver = startLoaded(false);
    auto* layers = driver->window().findChild<QTreeWidget*>("layers");
    layers->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
    QApplication::processEvents();
    EXPECT_FALSE(driver->scene().layers[0].visible);
    EXPECT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->scene().layers[0].visible);
    EXPECT_EQ(layers->topLevelItem(0)->checkState(0), Qt::Checked);
}

TEST_F(Workstation, AFarUnregisteredScanDoesNotMakeTheSceneSmall) {
    std::ofstream far(folder / "far.xyz");
    for (int i = 0; i < 100; ++i) far << 480000 + i % 10 << ' ' << 4370000 + i / 10 << " 30\n";
    far.close();
    auto driver = start(std::make_unique<InlineJobRunner>());
    ASSERT_TRUE(driver->window().openFiles({scans.target, folder / "far.xyz"}));
    for (const NamedView view : {NamedView::perspective, NamedView::top}) {
        driver->window().showNamedView(view);
        EXPECT_LT(driver->window().view().camera().position.norm(), 200);
    }
}

TEST_F(Workstation, ThreeClickedPairsAndATapeMakeAMeasurement) {
    auto driver = startLoaded(false);
    driver->window().showNamedView(NamedView::top);
    pickBox(*driver, 3);
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    const Measurement& box = driver->scene().measurements[0];
    EXPECT_EQ(box.object, "Length 1");
    ASSERT_EQ(box.picks.at("yard").size(), 3u);
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo pick Length 1, repeat 3");
    driver->typeInto(0, 1, "2.00");
    EXPECT_EQ(driver->scene().measurements[0].tape_m, 2.0);
    const auto& measured = driver->window().document().measured().lengths;
    ASSERT_FALSE(measured.empty());
    ASSERT_TRUE(measured[0].length);
    EXPECT_NEAR(measured[0].length->mean_m, 2.0, 0.06);
    ASSERT_TRUE(measured[0].re);
    EXPECT_TRUE(driver->label("repeats").startsWith("Repeats"));
    driver->answers().csv = QString::fromStdString(scans.target.string());
    const auto before = std::filesystem::file_size(scans.target);
    driver->trigger("export.csv");
    EXPECT_EQ(std::filesystem::file_size(scans.target), before) << "evidence is only read";
}

TEST_F(Workstation, APairPickedOnAFirstLookBecomesAsCertainAsTheWholeCloudAllows) {
    auto driver = startLoaded(false);
    Document& document = driver->window().document();
    const std::shared_ptr<const LayerData> whole = driver->scene().layers[0].data;
    LoadedGeometry thin{*whole->geometry, whole->info};
    ReadOptions every;
    every.keepEvery = 33;  // of rows of 126: no neighbours along a diagonal
    applyReadOptions(every, thin);
    auto look = std::make_shared<LayerData>(*whole);
    look->geometry = std::make_shared<const TriangleMesh>(std::move(thin.geometry));
    look->points = std::shared_ptr<const PointCloud>(look->geometry, &look->geometry->vertices);
    look->octree = std::make_shared<const Octree>(look->points);
    look->awaitedPoints = whole->points->size();
    document.replaceData(whole, look);

    driver->window().showNamedView(NamedView::top);
    driver->trigger("tool.distance");
    for (int repeat = 0; repeat < 2; ++repeat) {
        for (const Eigen::Vector3f& place : {Eigen::Vector3f(2, 2, 0), Eigen::Vector3f(3, -3, 0)}) {
            std::vector<Octree::Neighbour> nearest;
            look->octree->nearest(place - look->points->origin().cast<float>(), 1, nearest);
            driver->clickOn(look->points->point(nearest.at(0).point));
        }
        if (QWidget* focus = QApplication::focusWidget()) QTest::keyClick(focus, Qt::Key_Return);
    }
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    const PickedPair& pair = driver->scene().measurements[0].picks.at("yard").at(0);
    EXPECT_FALSE(pair.a.localSpacing_m || pair.b.localSpacing_m) << "that of the first look would stay";
    ASSERT_TRUE(document.measured().lengths.at(0).length);
    const auto before_m = document.measured().lengths[0].length->standardUncertainty_m;
    ASSERT_TRUE(before_m);
    document.replaceData(look, std::make_shared<LayerData>(*whole));
    EXPECT_LT(document.measured().lengths.at(0).length->standardUncertainty_m.value_or(9), 0.5 * *before_m);
}

TEST_F(Workstation, EscapeGivesUpAPair) {
    auto driver = startLoaded(false);
    driver->window().showNamedView(NamedView::top);
    driver->trigger("tool.distance");
    driver->clickOn(kBoxCorner);
    EXPECT_TRUE(driver->label("hint").contains("second end")) << driver->label("hint").toStdString();
    QTest::keyClick(driver->window().view().widget(), Qt::Key_Escape);
    EXPECT_TRUE(driver->label("hint").contains("first end"));
    driver->clickOn(kBoxCornerAlongX);
    EXPECT_TRUE(driver->scene().measurements.empty());
}

TEST_F(Workstation, DraggingTurnsTheViewAndPicksNothing) {
    auto driver = startLoaded(false);
    driver->trigger("tool.distance");
    QWidget* view = driver->window().view().widget();
    const Eigen::Vector3d before = driver->window().view().camera().position;
    QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, {300, 300});
    for (int x = 310; x <= 400; x += 10) {
        QMouseEvent move(QEvent::MouseMove, QPointF(x, 300), view->mapToGlobal(QPoint(x, 300)), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(view, &move);
    }
    QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, {400, 300});
    EXPECT_GT((driver->window().view().camera().position - before).norm(), 0.1);
    EXPECT_TRUE(driver->label("hint").contains("first end"));
}

TEST_F(Workstation, RegistersUndoesAndRedoes) {
    auto driver = startLoaded(true);
    ASSERT_TRUE(driver->trigger("register.run"));
    const Layer& source = *driver->scene().layer("second-scan");
    ASSERT_TRUE(source.registration) << "no registration entered";
    // The source was moved by +x: registering takes it back.
    const Eigen::Vector3d corner = sceneFromLayer(source) * Eigen::Vector3d(test::kMoved_m, -0.15, 0.05);
    EXPECT_LT(corner.norm(), 0.05);
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo register second scan");
    EXPECT_TRUE(driver->trigger("edit.undo"));
    EXPECT_FALSE(driver->scene().layer("second-scan")->registration);
    EXPECT_TRUE(driver->trigger("edit.redo"));
    EXPECT_TRUE(driver->scene().layer("second-scan")->registration);
}

TEST_F(Workstation, EverythingIsUndoneAndRedone) {
    auto driver = startLoaded(true);
    driver->window().showNamedView(NamedView::top);
    pickBox(*driver, 2);
    driver->typeInto(0, 1, "2.05");
    driver->typeInto(0, 0, "Box, length");
    int undone = 0;
    while (driver->trigger("edit.undo")) ++undone;
    EXPECT_EQ(undone, 5);
    EXPECT_TRUE(driver->scene().layers.empty());
    EXPECT_TRUE(driver->scene().measurements.empty());
    EXPECT_FALSE(driver->window().document().modified());
    while (driver->trigger("edit.redo")) --undone;
    EXPECT_EQ(undone, 0);
    ASSERT_NE(driver->scene().measurement("Box, length"), nullptr);
    EXPECT_EQ(driver->scene().measurement("Box, length")->tape_m, 2.05);
}

TEST_F(Workstation, SavesAndReopensTheSameCase) {
    auto driver = startLoaded(true);
    driver->window().showNamedView(NamedView::top);
    pickBox(*driver, 1);
    driver->typeInto(0, 1, "2.05");
    driver->answers().casePath = QString::fromStdString((folder / "yard.vestige").string());
    ASSERT_TRUE(driver->trigger("file.save"));
    EXPECT_FALSE(driver->window().document().modified());
    const auto measured = driver->window().document().measured();
    ASSERT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->window().document().modified());
    ASSERT_TRUE(driver->trigger("file.reopen"));
    EXPECT_FALSE(driver->window().document().modified());
    EXPECT_EQ(driver->scene().layers.size(), 2u);
    EXPECT_NE(driver->scene().layers[1].data, nullptr);
    const auto again = driver->window().document().measured();
    ASSERT_EQ(again.lengths.size(), measured.lengths.size());
    EXPECT_EQ(again.lengths[0].re, measured.lengths[0].re);
}

TEST_F(Workstation, ReopeningAsksAboutUnsavedChanges) {
    auto driver = startLoaded(true);
    driver->answers().casePath = QString::fromStdString((folder / "yard.vestige").string());
    ASSERT_TRUE(driver->trigger("file.save"));
    ASSERT_TRUE(driver->trigger("register.run"));
    driver->answers().unsaved = FileChooser::Unsaved::stay;
    ASSERT_TRUE(driver->trigger("file.reopen"));
    EXPECT_TRUE(driver->scene().layer("second-scan")->registration) << "nothing was lost";
    driver->answers().unsaved = FileChooser::Unsaved::discard;
    ASSERT_TRUE(driver->trigger("file.reopen"));
    EXPECT_FALSE(driver->scene().layer("second-scan")->registration);
}

TEST_F(Workstation, DroppedFilesAreOpened) {
    auto driver = start(std::make_unique<InlineJobRunner>());
    QMimeData dropped;
    dropped.setUrls({QUrl::fromLocalFile(QString::fromStdString(scans.target.string()))});
    QDragEnterEvent enter({400, 300}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&driver->window(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(400, 300), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&driver->window(), &drop);
    QApplication::processEvents();
    EXPECT_EQ(driver->scene().layers.size(), 1u);
}

TEST_F(Workstation, ExportsTheReportAndTheTable) {
    auto driver = startLoaded(true);
    driver->window().showNamedView(NamedView::top);
    pickBox(*driver, 3);
    driver->typeInto(0, 1, "2.00");
    driver->answers().csv = QString::fromStdString((folder / "table.csv").string());
    ASSERT_TRUE(driver->trigger("export.csv"));
    std::ifstream csv(folder / "table.csv");
    std::string header;
    std::getline(csv, header);
    EXPECT_TRUE(header.starts_with("object,method,tape_m,measured_1_m")) << header;
    driver->answers().folder = QString::fromStdString((folder / "report").string());
    ASSERT_TRUE(driver->trigger("export.report"));
    for (const char* file : {"report.pdf", "measurements.csv", "accuracy.csv", "registration.json",
                             "fused.las", "manifest.json"})
        EXPECT_TRUE(std::filesystem::exists(folder / "report" / file)) << file;
}

TEST_F(Workstation, WorksInAThreadWhileTheViewStaysAlive) {
    auto driver = start(std::make_unique<ThreadedJobRunner>());
    ASSERT_TRUE(driver->window().openFiles({scans.target, scans.source}));
    EXPECT_TRUE(driver->window().jobs().busy());
    EXPECT_FALSE(driver->enabled("file.add-files"));
    ASSERT_TRUE(driver->settle());
    ASSERT_EQ(driver->scene().layers.size(), 2u);
    ASSERT_TRUE(driver->trigger("register.run"));
    driver->window().showNamedView(NamedView::top);
    ASSERT_TRUE(driver->settle());
    EXPECT_TRUE(driver->scene().layer("second-scan")->registration);
    driver->answers().folder = QString::fromStdString((folder / "report").string());
    ASSERT_TRUE(driver->trigger("export.report"));
    ASSERT_TRUE(driver->settle());
    EXPECT_TRUE(std::filesystem::exists(folder / "report" / "report.pdf"));
}

TEST_F(Workstation, ACancelledRegistrationLeavesTheCaseAsItWas) {
    auto driver = start(std::make_unique<ThreadedJobRunner>());
    ASSERT_TRUE(driver->window().openFiles({scans.target, scans.source}));
    ASSERT_TRUE(driver->settle());
    ASSERT_TRUE(driver->trigger("register.run"));
    driver->window().jobs().cancel();
    ASSERT_TRUE(driver->settle());
    EXPECT_FALSE(driver->scene().layer("second-scan")->registration);
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo add yard, second scan");
}

TEST_F(Workstation, SaysHowLongItTookToAnswer) {
    auto driver = startLoaded(false);
    ASSERT_TRUE(driver->trigger("help.responsiveness"));
    EXPECT_TRUE(driver->window().findChild<NoticeBar*>("notice")->text().contains("From now on"));
    ASSERT_TRUE(driver->trigger("view.top"));
    ASSERT_TRUE(driver->trigger("help.responsiveness"));
    EXPECT_TRUE(driver->window().findChild<NoticeBar*>("notice")->text().contains("longest drawing call"));
}

}  // namespace
}  // namespace vestige
