#include <gtest/gtest.h>

#include <QAction>
#include <QElapsedTimer>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <cmath>
#include <ctime>

#include "app/offscreen/OffscreenApplication.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/LasWriter.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/document/Document.h"
#include "ui/jobs/ThreadedJobRunner.h"
#include "ui/print/PdfPrinter.h"

namespace vestige {
namespace {

constexpr std::uint32_t kPoints = 2'000'000;
/// Of the processors: a loaded machine keeps to it, and a job that goes on in spite of cancelling takes more.
constexpr double kLongest_s = 4;
constexpr int kHung_ms = 240'000;

/// Rolling ground with walls, 60 m a side; the second is turned and moved a little.
std::filesystem::path writeGround(const std::filesystem::path& file, double turned_rad) {
    PointCloudBuilder builder(Eigen::Vector3d(483000, 4375000, 30));
    builder.resize(kPoints);
    const double step = 60.0 / std::sqrt(kPoints);
    const auto row = static_cast<std::uint32_t>(60 / step);
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const double x = step * (i % row) - 30;
        const double y = step * (i / row) - 30;
        const double wall = std::fmod(std::abs(x), 11) < 0.3 || std::fmod(std::abs(y), 17) < 0.3 ? 3 : 0;
        const double z = std::sin(0.3 * x) * std::cos(0.2 * y) + wall * std::fmod(0.37 * i, 1);
        builder.setPoint(i, {483000 + x * std::cos(turned_rad) - y * std::sin(turned_rad) + 2 * turned_rad,
                             4375000 + x * std::sin(turned_rad) + y * std::cos(turned_rad), 30 + z});
    }
    const PointCloud cloud = std::move(builder).build();
    EXPECT_TRUE(writeLas(file, {{&cloud, {}, 1}}, {}));
    return file;
}

TEST(CancelWindow, EveryKindOfJobEndsSoonAfterCancel) {
    const test::TemporaryFolder folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString((folder / "settings").string()));
    const auto first = writeGround(folder / "first.las", 0);
    const auto second = writeGround(folder / "second.las", 0.02);
    test::WindowDriver driver(std::make_unique<MainWindow>(offscreenSurface(), offscreenRenderer(),
                                                           std::make_unique<PdfPrinter>(), nullptr,
                                                           std::make_unique<ThreadedJobRunner>()));
    const auto files = [&] {
        return QStringList{QString::fromStdString(first.string()), QString::fromStdString(second.string())};
    };
    driver.answers().files = files();
    driver.answers().folder = QString::fromStdString((folder / "report").string());
    auto* cancel = driver.window().findChild<QPushButton*>("cancel");
    const auto cancelled = [&](const char* id, int after_ms) {
        ASSERT_TRUE(driver.enabled(id)) << id;
        driver.window().findChild<QAction*>(id)->trigger();
        // The strip hears of the job by an event.
        while (driver.window().jobs().busy() && !cancel->isVisible()) QTest::qWait(1);
        QTest::qWait(after_ms);
        if (driver.window().jobs().busy()) {
            const std::clock_t before = std::clock();
            QTest::mouseClick(cancel, Qt::LeftButton);
            QElapsedTimer clock;
            clock.start();
            while (driver.window().jobs().busy() && clock.elapsed() < kHung_ms) QTest::qWait(5);
            EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, kLongest_s)
                << id << ", cancelled after " << after_ms << " ms";
        }
        ASSERT_TRUE(driver.settle());
    };
    for (const int after_ms : {1, 300}) cancelled("file.add-files", after_ms);
    if (driver.scene().layers.size() < 2) {
        ASSERT_TRUE(driver.trigger("file.new"));
        ASSERT_TRUE(driver.trigger("file.add-files"));
        ASSERT_TRUE(driver.settle());
    }
    ASSERT_GE(driver.scene().layers.size(), 2U);
    for (const char* id : {"file.verify", "register.run", "register.auto", "export.report"})
        for (const int after_ms : {1, 300, 1500}) cancelled(id, after_ms);
}

}  // namespace
}  // namespace vestige
