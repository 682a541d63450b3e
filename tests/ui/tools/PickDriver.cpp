#include "tests/ui/tools/PickDriver.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTest>

#include "app/offscreen/OffscreenApplication.h"
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
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString((folder_ / "settings").string()));
    const SampleScans scans = writeSampleScans(folder_.path());
    driver_ = std::make_unique<WindowDriver>(std::make_unique<MainWindow>(
        offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::make_unique<InlineJobRunner>()));
    std::vector<std::filesystem::path> files{scans.target};
    if (both) files.push_back(scans.source);
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
    // Of a click that takes nothing nothing is heard: then this is how long a fit may take.
    wait([&] { return hint() != before; }, 400);
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
