// How long the interface thread is held while a whole case is worked through in the real window, drawn by
// OSMesa: bin/bench_window CASE [WIDTHxHEIGHT]. CASE: case.json of `vestige-cli simulate bicycle --out
// FOLDER`, the largest sample. Prints the longest events with their names, times of frames while moving, of
// cancelling and of the steps.
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "app/offscreen/OffscreenApplication.h"
#include "core/scene/Edits.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/document/Autosave.h"
#include "ui/document/Document.h"
#include "ui/jobs/ThreadedJobRunner.h"
#include "ui/print/PdfPrinter.h"
#include "ui/view/SceneView.h"
#include "ui/watch/EventWatch.h"

using namespace vestige;

namespace {

struct Bench {
    test::WindowDriver& driver;
    EventWatch& watch;

    /// What held the window during a step, and how long the step took. Actions are triggered by events of
    /// their own, as the user's are, so that the watch sees them.
    void step(const char* name, const std::function<void()>& begin, int seconds = 900) {
        watch.forget();
        QElapsedTimer clock;
        clock.start();
        QTimer::singleShot(0, &driver.window(), begin);
        QTest::qWait(10);
        for (int i = 0; i < 100 * seconds && (driver.window().jobs().busy() || saving()); ++i)
            QTest::qWait(10);
        for (int i = 0; i < 3000 && !driver.window().view().isComplete(); ++i) QTest::qWait(10);
        std::printf("| %s | %.2f | %.0f | %.0f | %.0f | %s |\n", name,
                    1e-3 * static_cast<double>(clock.elapsed()), 1e3 * watch.worst_s(),
                    1e3 * watch.worstWork_s(), 1e3 * watch.worstDrawing_s(),
                    watch.held().empty() ? "" : qPrintable(watch.held().front().what));
        for (const EventWatch::Held& held : watch.held())
            if (held.worst_s > 0.03)
                std::fprintf(stderr, "    %3.0f ms (processor %.0f), %d times: %s\n", 1e3 * held.worst_s,
                             1e3 * held.worstWork_s, held.times, qPrintable(held.what));
        std::fflush(stdout);
        worst = std::max(worst, watch.worst_s());
        worstWork = std::max(worstWork, watch.worstWork_s());
    }
    bool saving() { return driver.window().autosave() && driver.window().autosave()->saving(); }
    void act(const char* id) {
        step(id, [this, id] { trigger(id); });
    }
    void trigger(const char* id) {
        auto* action = driver.window().findChild<QAction*>(id);
        if (!action || !action->isEnabled())
            std::fprintf(stderr, "    %s is not possible\n", id);
        else
            action->trigger();
    }

    /// Begins the action's job, and cancels it once it runs for `after_ms`.
    void cancelled(const char* id, int after_ms) {
        trigger(id);
        QTest::qWait(after_ms);
        if (!driver.window().jobs().busy())
            return std::printf("| cancel %s | done before | | | | |\n", id), void();
        QElapsedTimer clock;
        clock.start();
        driver.window().jobs().cancel();
        while (driver.window().jobs().busy()) QTest::qWait(2);
        std::printf("| cancel %s after %.1f s | %.2f | | | | |\n", id, 1e-3 * after_ms,
                    1e-3 * static_cast<double>(clock.elapsed()));
        std::fflush(stdout);
    }

    double worst = 0;
    double worstWork = 0;
};

void send(QWidget& widget, QEvent::Type type, const QPoint& place) {
    QMouseEvent event(type, place, widget.mapToGlobal(place),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

void orbit(test::WindowDriver& driver, int frames) {
    QWidget& widget = *driver.window().view().widget();
    std::vector<double> taken;
    QPoint place(widget.width() / 2, widget.height() / 2);
    send(widget, QEvent::MouseButtonPress, place);
    for (int i = 0; i < frames; ++i) {
        QElapsedTimer clock;
        clock.start();
        place += QPoint(5, i % 3);
        send(widget, QEvent::MouseMove, place);
        QApplication::processEvents();
        QApplication::processEvents();
        taken.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    }
    send(widget, QEvent::MouseButtonRelease, place);
    std::sort(taken.begin(), taken.end());
    std::printf("| orbit, %d frames | median %.0f ms, worst %.0f ms | | | | |\n", frames,
                taken[taken.size() / 2], taken.back());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_window CASE [cancel|ACTION]\n");
        return 2;
    }
    const test::TemporaryFolder folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString((folder / "settings").string()));
    const OffscreenApplication application;
    EventWatch watch;
    std::printf(
        "| step | s | longest event, ms | its processor, ms | longest drawing call, ms | what it was "
        "|\n|---|---|---|---|---|---|\n");
    QElapsedTimer clock;
    clock.start();
    test::WindowDriver driver(std::make_unique<MainWindow>(offscreenSurface(), offscreenRenderer(),
                                                           std::make_unique<PdfPrinter>(), nullptr,
                                                           std::make_unique<ThreadedJobRunner>()));
    driver.window().keepEdits(folder / "user");
    std::printf("| window made and shown | %.2f | | | | |\n", 1e-3 * static_cast<double>(clock.elapsed()));
    Bench bench{driver, watch};
    MainWindow& window = driver.window();
    const std::filesystem::path file(argv[1]);
    const std::string part = argc > 2 ? argv[2] : "";
    bench.step("open the case", [&] { window.openCase(file); });
    driver.answers().folder = QString::fromStdString((folder / "report").string());
    const auto cancelAll = [&] {
        for (const char* id :
             {"file.verify", "register.run", "register.auto", "register.residual", "clean.outliers",
              "clean.ground", "clean.objects", "export.csv", "export.report"})
            for (const int after_ms : {100, 1000, 5000}) bench.cancelled(id, after_ms);
    };
    if (part == "cancel") return cancelAll(), 0;
    if (!part.empty()) return bench.act(part.c_str()), 0;
    driver.answers().casePath = QString::fromStdString((folder / "night.vestige").string());
    bench.act("file.save-as");
    orbit(driver, 60);
    bench.step("complete again", [] {});
    bench.act("view.four");
    orbit(driver, 60);
    bench.act("view.four");
    bench.act("register.run");
    bench.act("measure.aims");
    for (const char* id :
         {"view.color-height", "view.color-intensity", "view.color-source", "register.residual"})
        bench.act(id);
    bench.step("measure", [&] { driver.trigger("tool.distance"); });
    bench.step("rename", [&] { window.document().perform(setCaseDetails("night", "bench", {})); });
    bench.act("edit.undo");
    bench.act("edit.redo");
    bench.act("file.save");
    bench.act("file.verify");
    driver.answers().csv = QString::fromStdString((folder / "table.csv").string());
    bench.act("export.csv");
    for (const char* id : {"clean.outliers", "clean.clear", "clean.ground", "clean.clear", "clean.objects"})
        bench.act(id);
    bench.act("export.report");
    cancelAll();
    std::printf("\nlongest of all without drawing calls: %.0f ms, of the processor %.0f ms\n",
                1e3 * bench.worst, 1e3 * bench.worstWork);
    return 0;
}
