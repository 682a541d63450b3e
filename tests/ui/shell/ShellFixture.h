#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTest>
#include <memory>
#include <stdexcept>

#include "app/offscreen/OffscreenApplication.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/print/PdfPrinter.h"

namespace vestige::test {

/// A window with settings and data of its own, and two small scans to open in it.
class ShellWindow : public testing::Test {
  public:
    ShellWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, path("settings"));
        qputenv("XDG_DATA_HOME", path("data").toLocal8Bit());
        scans = writeSampleScans(folder.path());
    }
    ~ShellWindow() override {
        driver.reset();
        qunsetenv("XDG_DATA_HOME");
    }

    void start() {
        driver.reset();
        driver = std::make_unique<WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), std::make_unique<PdfPrinter>(), nullptr,
            std::make_unique<InlineJobRunner>()));
    }
    void startLoaded() {
        start();
        EXPECT_TRUE(driver->window().openFiles({scans.target, scans.source}));
    }
    /// An object picked on the box that often.
    void pickBox(int times) {
        driver->trigger("tool.distance");
        for (int i = 0; i < times; ++i) {
            driver->clickOn(kBoxCorner);
            driver->clickOn(kBoxCornerAlongX);
            // A new object's name is being edited now.
            if (QWidget* focus = QApplication::focusWidget()) QTest::keyClick(focus, Qt::Key_Return);
        }
    }
    QString path(const char* name) const { return QString::fromStdString((folder / name).string()); }
    template <class Widget>
    Widget& widget(const char* name) {
        auto* found = driver->window().findChild<Widget*>(name);
        if (!found) throw std::runtime_error(std::string("no widget ") + name);
        return *found;
    }

    TemporaryFolder folder;
    SampleScans scans;
    std::unique_ptr<WindowDriver> driver;
};

}  // namespace vestige::test
