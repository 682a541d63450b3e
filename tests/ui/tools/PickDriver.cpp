#include "tests/ui/tools/PickDriver.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTest>
#include <fstream>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/Numbers.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/view/SceneView.h"

namespace vestige::test {
namespace {

void send(QWidget* widget, QEvent::Type type, const QPoint& place, Qt::MouseButton button,
          Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
    QMouseEvent event(type, QPointF(place), QPointF(widget->mapToGlobal(place)), button, buttons, modifiers);
    QApplication::sendEvent(widget, &event);
}

}  // namespace

PickDriver::PickDriver(bool both) {
    const SampleScans scans = writeSampleScans(folder_.path());
    std::vector<std::filesystem::path> files{scans.target};
    if (both) files.push_back(scans.source);
    start(files);
}

PickDriver::PickDriver(Box) {
    const std::filesystem::path file = folder_ / "box.xyz";
    std::ofstream out(file);
    constexpr double kStep = 0.05;
    for (int i = 0; i <= 80; ++i) {
        for (int j = 0; j <= 60; ++j) {
            const Eigen::Vector2d at(-2 + kStep * i, -1.5 + kStep * j);
            const bool under = std::abs(at.x()) < 0.999 && std::abs(at.y()) < 0.499;
            out << fixedText(at.x(), 4) << ' ' << fixedText(at.y(), 4) << (under ? " 0.8\n" : " 0\n");
        }
    }
    for (int up = 0; up <= 16; ++up) {
        const std::string height = ' ' + fixedText(kStep * up, 4) + '\n';
        for (int i = 0; i <= 40; ++i)
            for (const char* y : {" -0.5", " 0.5"}) out << fixedText(-1 + kStep * i, 4) << y << height;
        for (int j = 1; j < 20; ++j)
            for (const char* x : {"-1 ", "1 "}) out << x << fixedText(-0.5 + kStep * j, 4) << height;
    }
    out.close();
    start({file});
}

void PickDriver::start(const std::vector<std::filesystem::path>& files) {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString((folder_ / "settings").string()));
    driver_ = std::make_unique<WindowDriver>(std::make_unique<MainWindow>(
        offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::make_unique<InlineJobRunner>()));
    EXPECT_TRUE(driver_->window().openFiles(files));
    driver_->window().showNamedView(NamedView::top);
}

QWidget* PickDriver::view() {
    return driver_->window().view().widget();
}

QPoint PickDriver::at(const Eigen::Vector3d& world) {
    const auto seen = driver_->window().view().camera().project(world);
    return {static_cast<int>(std::floor(seen->pixel.x())), static_cast<int>(std::floor(seen->pixel.y()))};
}

void PickDriver::hover(const QPoint& place) {
    send(view(), QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
}

void PickDriver::press(const QPoint& place, Qt::KeyboardModifiers modifiers) {
    send(view(), QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton, modifiers);
}

void PickDriver::moveHeld(const QPoint& place, Qt::KeyboardModifiers modifiers) {
    send(view(), QEvent::MouseMove, place, Qt::NoButton, Qt::LeftButton, modifiers);
}

void PickDriver::release(const QPoint& place, Qt::KeyboardModifiers modifiers) {
    send(view(), QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton, modifiers);
}

void PickDriver::click(const QPoint& place, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    const QString before = hint();
    send(view(), QEvent::MouseButtonPress, place, button, button, modifiers);
    send(view(), QEvent::MouseButtonRelease, place, button, Qt::NoButton, modifiers);
    // Of a click that changes nothing nothing is heard; fits take milliseconds, on a busy machine more.
    wait([&] { return hint() != before; }, 1500);
}

void PickDriver::doubleClick(const QPoint& place) {
    press(place);
    release(place);
    send(view(), QEvent::MouseButtonDblClick, place, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    release(place);
}

void PickDriver::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
    press(from, modifiers);
    for (const QPoint& place : {(2 * from + to) / 3, (from + 2 * to) / 3, to}) moveHeld(place, modifiers);
    release(to, modifiers);
    QApplication::processEvents();
}

void PickDriver::key(int key) {
    QTest::keyClick(view(), static_cast<Qt::Key>(key));
    QApplication::processEvents();
}

void PickDriver::pickPair(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    click(at(a));
    click(at(b));
    if (QWidget* focus = QApplication::focusWidget(); focus && focus != view())
        QTest::keyClick(focus, Qt::Key_Return);
    view()->setFocus();
}

QString PickDriver::caption() {
    auto* loupe = view()->findChild<QWidget*>("loupe");
    return loupe && loupe->isVisible() ? loupe->accessibleDescription() : QString();
}

bool PickDriver::wait(const std::function<bool()>& until, int milliseconds) {
    QElapsedTimer clock;
    clock.start();
    while (!until() && clock.elapsed() < milliseconds) QTest::qWait(5);
    return until();
}

}  // namespace vestige::test
