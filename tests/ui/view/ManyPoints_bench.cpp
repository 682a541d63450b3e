// How the view bears many points on this machine's processors alone (OSMesa): build it, then
// bin/bench_view [MILLIONS [WIDTHxHEIGHT]]. Frames are those of SceneView as the window has it.
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"
#include "ui/view/SceneView.h"

using namespace vestige;

namespace {

std::string memory(const char* key) {
    std::ifstream status("/proc/self/status");
    std::string line;
    while (std::getline(status, line))
        if (line.starts_with(key)) return line.substr(line.find_first_not_of(" \t", line.find(':') + 1));
    return "unknown";
}

/// Time on the wall, and of all processors together: what a busy machine does not falsify.
class Clock {
  public:
    Clock() { timer_.start(); }
    double seconds() const { return 1e-9 * static_cast<double>(timer_.nsecsElapsed()); }
    double processors() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

  private:
    QElapsedTimer timer_;
    std::clock_t start_ = std::clock();
};

/// Rolling ground of 1 km a side with walls and poles, in the order of a flight's lines, 3 cm of noise.
std::shared_ptr<const TriangleMesh> flownGround(std::size_t points) {
    const Eigen::Vector3d corner(483000, 4375000, 30);
    PointCloudBuilder builder(corner);
    builder.resize(points);
    std::vector<float> intensity(points);
    const double lines = 40;
    parallelFor(points, 1 << 16, [&](std::size_t begin, std::size_t end) {
        Random random(begin);
        for (std::size_t i = begin; i < end; ++i) {
            const double along = lines * static_cast<double>(i) / static_cast<double>(points);
            const double x = 1000 * (along - std::floor(along));
            const double y = 25 * (std::floor(along) + random.uniform());
            double z = 8 * std::sin(0.01 * x) * std::cos(0.013 * y) + 0.03 * random.uniform();
            const bool wall = std::fmod(x, 60) < 0.4 && std::fmod(y, 40) < 25;
            if (wall) z += 6 * random.uniform();
            builder.setPoint(i, corner + Eigen::Vector3d(x, y, z));
            intensity[i] = static_cast<float>(1000 + 800 * std::sin(0.5 * x));
        }
    });
    for (const float value : intensity) builder.attributes().intensity.push_back(value);
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = std::move(builder).build();
    return mesh;
}

struct Frames {
    std::vector<double> seconds;
    std::vector<double> processors;
    void add(const Clock& clock) {
        seconds.push_back(clock.seconds());
        processors.push_back(clock.processors());
    }
    void print(const char* what) {
        std::sort(seconds.begin(), seconds.end());
        std::sort(processors.begin(), processors.end());
        std::printf("%-34s median %6.1f ms, worst %6.1f ms of %zu (processors %.1f, %.1f)\n", what,
                    1e3 * seconds[seconds.size() / 2], 1e3 * seconds.back(), seconds.size(),
                    1e3 * processors[seconds.size() / 2], 1e3 * processors.back());
    }
};

void send(QWidget& widget, QEvent::Type type, const QPoint& place, Qt::MouseButton button) {
    QMouseEvent event(type, place, widget.mapToGlobal(place),
                      type == QEvent::MouseMove ? Qt::NoButton : button,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : button, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

void untilComplete(SceneView& view, const char* what) {
    const Clock clock;
    Frames steps;
    while (!view.isComplete() && clock.seconds() < 120) {
        const Clock step;
        QApplication::processEvents();
        if (step.seconds() > 0.002) steps.add(step);
    }
    std::printf("%-34s %.2f s (processors %.2f s)\n", what, clock.seconds(), clock.processors());
    if (!steps.seconds.empty()) steps.print("    its steps");
}

Frames drag(SceneView& view, Qt::MouseButton button, int frames) {
    Frames taken;
    QWidget& widget = *view.widget();
    QPoint place(widget.width() / 2, widget.height() / 2);
    send(widget, QEvent::MouseButtonPress, place, button);
    for (int i = 0; i < frames; ++i) {
        const Clock clock;
        place += QPoint(7, i % 3);
        send(widget, QEvent::MouseMove, place, button);
        QApplication::processEvents();
        QApplication::processEvents();
        taken.add(clock);
    }
    send(widget, QEvent::MouseButtonRelease, place, button);
    return taken;
}

}  // namespace

int main(int argc, char** argv) {
    const double millions = argc > 1 ? std::atof(argv[1]) : 100;
    const auto points = static_cast<std::size_t>(millions * 1e6);
    const OffscreenApplication application;
    Clock clock;
    ViewLayer layer;
    layer.id = layer.name = "ground";
    layer.geometry = flownGround(points);
    std::printf("%.0f million points made in %.1f s, resident %s\n", millions, clock.seconds(),
                memory("VmRSS").c_str());
    clock = {};
    layer.octree = std::make_shared<Octree>(
        std::shared_ptr<const PointCloud>(layer.geometry, &layer.geometry->vertices));
    std::printf("octree in %.1f s, resident %s\n", clock.seconds(), memory("VmRSS").c_str());

    QWidget window;
    window.resize(1400, 900);
    SceneView view(offscreenSurface(), &window);
    view.widget()->resize(1400, 900);
    window.show();
    QApplication::processEvents();
    ViewDescription description;
    description.layers.push_back(layer);
    description.camera = fitCamera(bounds(description), NamedView::perspective, 1400, 900);
    clock = {};
    view.show(description);
    view.setPickIndex({layer.octree});
    QApplication::processEvents();
    QApplication::processEvents();
    std::printf("first picture after %.0f ms (processors %.0f)\n", 1e3 * clock.seconds(),
                1e3 * clock.processors());
    untilComplete(view, "complete, seen from afar");
    drag(view, Qt::LeftButton, 60).print("orbit from afar, complete before");
    untilComplete(view, "complete again");
    ViewCamera near = view.camera();
    const Eigen::Vector3d forward = near.direction();
    near.position = near.focalPoint - 60 * forward;
    view.setCamera(near);
    drag(view, Qt::LeftButton, 60).print("orbit at 60 m, nothing there yet");
    untilComplete(view, "complete, seen from 60 m");
    drag(view, Qt::RightButton, 60).print("pan at 60 m");
    untilComplete(view, "complete again");
    Frames picks;
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        const Clock pick;
        hits += view.pickAt({100 + 6 * i, 80 + (i * 37) % 740}) ? 1 : 0;
        picks.add(pick);
    }
    picks.print("pick under the mouse");
    std::printf("%d of 200 places had a point\n", hits);
    description.colorMode = ColorMode::intensity;
    view.show(description);
    untilComplete(view, "other colours");
    std::printf("resident %s, peak %s\n", memory("VmRSS").c_str(), memory("VmHWM").c_str());
    return 0;
}
