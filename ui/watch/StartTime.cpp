#include "ui/watch/StartTime.h"

#include <time.h>
#include <unistd.h>

#include <QAbstractEventDispatcher>
#include <QEvent>
#include <QFile>
#include <QWidget>
#include <QWindow>
#include <memory>

namespace vestige {
namespace {

/// Sees the window's paint events, and the first wait after one.
class FirstRest : public QObject {
  public:
    FirstRest(QWidget& window, std::function<void()> usable)
        : QObject(&window), window_(window), usable_(std::move(usable)) {
        window.installEventFilter(this);
        connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::aboutToBlock, this,
                [this] { rest(); });
    }
    bool eventFilter(QObject*, QEvent* event) override {
        painted_ = painted_ || event->type() == QEvent::Paint;
        return false;
    }

  private:
    void rest() {
        const QWindow* handle = window_.windowHandle();
        if (!painted_ || !handle || !handle->isExposed() || !usable_) return;
        std::exchange(usable_, nullptr)();
        deleteLater();
    }

    QWidget& window_;
    std::function<void()> usable_;
    bool painted_ = false;
};

}  // namespace

double processAge_s() {
    QFile stat("/proc/self/stat");
    if (!stat.open(QIODevice::ReadOnly)) return -1;
    // The name, in parentheses, may hold anything; the start is the 20th field after it.
    const QByteArray line = stat.readAll();
    const auto fields = line.mid(line.lastIndexOf(')') + 2).split(' ');
    timespec now{};
    if (fields.size() < 20 || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return -1;
    const double started_s = fields[19].toDouble() / static_cast<double>(sysconf(_SC_CLK_TCK));
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - started_s;
}

void whenUsable(QWidget& window, std::function<void()> usable) {
    new FirstRest(window, std::move(usable));
}

}  // namespace vestige
