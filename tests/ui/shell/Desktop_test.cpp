#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QSettings>

#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/print/PdfPrinter.h"
#include "ui/view/NativeSurface.h"
#include "ui/view/PictureRenderer.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// The window as the desktop program makes it, on an X server: VTK's own widget, a worker thread.
TEST(Desktop, OpenRegisterPickUndoExport) {
    const test::TemporaryFolder folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString((folder / "settings").string()));
    const auto scans = test::writeSampleScans(folder.path());
    test::WindowDriver driver(
        std::make_unique<MainWindow>(nativeSurface(), nativeRenderer(), std::make_unique<PdfPrinter>()));

    driver.window().open(
        {QString::fromStdString(scans.target.string()), QString::fromStdString(scans.source.string())});
    ASSERT_TRUE(driver.settle());
    ASSERT_EQ(driver.scene().layers.size(), 2u);

    ASSERT_TRUE(driver.trigger("register.run"));
    ASSERT_TRUE(driver.settle());
    ASSERT_TRUE(driver.scene().layer("second-scan")->registration);

    ASSERT_TRUE(driver.trigger("view.top"));
    ASSERT_TRUE(driver.trigger("tool.distance"));
    driver.clickOn(test::kBoxCorner);
    driver.clickOn(test::kBoxCornerAlongX);
    ASSERT_EQ(driver.scene().measurements.size(), 1u);

    const QImage picture = driver.window().view().grab();
    ASSERT_FALSE(picture.isNull());
    int lit = 0;
    for (int y = 0; y < picture.height(); y += 4)
        for (int x = 0; x < picture.width(); x += 4) lit += qGray(picture.pixel(x, y)) > 60;
    EXPECT_GT(lit, 500) << "the view shows no points";

    ASSERT_TRUE(driver.trigger("edit.undo"));
    EXPECT_TRUE(driver.scene().measurements.empty());
    ASSERT_TRUE(driver.trigger("edit.redo"));
    ASSERT_EQ(driver.scene().measurements.size(), 1u);

    driver.answers().folder = QString::fromStdString((folder / "report").string());
    ASSERT_TRUE(driver.trigger("export.report"));
    ASSERT_TRUE(driver.settle());
    for (const char* file : {"report.pdf", "measurements.csv", "fused.las"})
        EXPECT_TRUE(std::filesystem::exists(folder / "report" / file)) << file;
}

}  // namespace
}  // namespace vestige

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    vestige::setNativeSurfaceFormat();
    QApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
