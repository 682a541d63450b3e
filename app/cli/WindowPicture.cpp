#include "app/cli/WindowPicture.h"

#include <QApplication>
#include <QImage>
#include <QPixmap>

#include "app/offscreen/OffscreenApplication.h"
#include "core/scene/CaseFile.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/print/PdfPrinter.h"
#include "ui/shell/MainWindow.h"
#include "ui/view/PngFile.h"
#include "ui/view/SceneView.h"

namespace vestige::cli {

Status drawWindow(const WindowPicture& wanted) {
    MainWindow window(offscreenSurface(), offscreenRenderer(), std::make_unique<PdfPrinter>(), nullptr,
                      std::make_unique<InlineJobRunner>());
    window.resize(wanted.width_px, wanted.height_px);
    window.show();
    QApplication::processEvents();
    const bool isCase = wanted.inputs.size() == 1 && looksLikeCase(wanted.inputs.front());
    const Status opened = isCase ? window.openCase(wanted.inputs.front())
                                 : window.openFiles({wanted.inputs.begin(), wanted.inputs.end()});
    if (!opened) return opened;
    window.setOverlay(wanted.overlay);
    QApplication::processEvents();
    window.showNamedView(wanted.view);
    // Layouts and palettes settle with the events; then the points that are still to come are drawn at once.
    for (int round = 0; round < 5; ++round) QApplication::processEvents();
    window.view().completePicture();
    return writePng(window.grab().toImage().convertToFormat(QImage::Format_RGB32), wanted.png);
}

}  // namespace vestige::cli
