#pragma once

#include <QPoint>
#include <functional>
#include <memory>

#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"

namespace vestige::test {

/// A window with the yard of SampleScans loaded, seen from above, and the hand that picks in it.
class PickDriver {
  public:
    explicit PickDriver(bool both = false);
    /// In place of the yard a box like the one there, sampled every 50 mm on five sides, on a ground.
    struct Box {};
    explicit PickDriver(Box);

    WindowDriver& window() { return *driver_; }
    const SceneState& scene() const { return driver_->scene(); }
    QWidget* view();
    /// The pixel of the view where the point is seen.
    QPoint at(const Eigen::Vector3d& world);

    void hover(const QPoint& place);
    /// A click there; waits for what is fitted.
    void click(const QPoint& place, Qt::MouseButton button = Qt::LeftButton,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void doubleClick(const QPoint& place);
    void press(const QPoint& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void moveHeld(const QPoint& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void release(const QPoint& place, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void key(int key);
    /// Picks a repeat of the selected object; ends the editing of a new one's name.
    void pickPair(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

    QString hint() { return driver_->label("hint"); }
    /// "": no loupe is shown.
    QString caption();

    static bool wait(const std::function<bool()>& until, int milliseconds = 10'000);

  private:
    void start(const std::vector<std::filesystem::path>& files);

    TemporaryFolder folder_;
    std::unique_ptr<WindowDriver> driver_;
};

}  // namespace vestige::test
