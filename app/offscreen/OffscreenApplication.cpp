#include "app/offscreen/OffscreenApplication.h"

#include <array>
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "app/offscreen/OsMesaContext.h"
#include "ui/view/PaintedSurface.h"
#include "ui/view/PictureRenderer.h"
#include "ui/watch/WatchedApplication.h"

namespace vestige {

namespace {

/// Qt's messages on stderr, without the one about a folder that only a desktop session has.
void passOn(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (text.startsWith(QLatin1String("QStandardPaths: "))) return;
    std::fprintf(stderr, "%s\n", qPrintable(text));
    if (type == QtFatalMsg) std::abort();
}

}  // namespace

struct OffscreenApplication::Private {
    // QApplication keeps references to both for its whole life.
    std::array<char, 12> program{"vestige-cli"};
    std::array<char*, 2> arguments{program.data(), nullptr};
    int count = 1;
    std::unique_ptr<QApplication> application;
};

OffscreenApplication::OffscreenApplication(double scale) : d_(std::make_unique<Private>()) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // The same picture on every machine, whatever the desktop of the user asks for.
    qputenv("QT_SCALE_FACTOR", QByteArray::number(scale));
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    qunsetenv("QT_QPA_PLATFORMTHEME");
    qunsetenv("QT_STYLE_OVERRIDE");
    qInstallMessageHandler(passOn);
    d_->application = std::make_unique<WatchedApplication>(d_->count, d_->arguments.data());
    // Qt has taken the environment's locale; numbers are written with a point everywhere.
    std::setlocale(LC_NUMERIC, "C");
}

OffscreenApplication::~OffscreenApplication() = default;

QApplication& OffscreenApplication::application() {
    return *d_->application;
}

ViewSurfaceFactory offscreenSurface() {
    return paintedSurface(osMesaContext);
}

std::unique_ptr<ViewRenderer> offscreenRenderer() {
    return pictureRenderer(osMesaContext);
}

}  // namespace vestige
