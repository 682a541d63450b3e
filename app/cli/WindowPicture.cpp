#include "app/cli/WindowPicture.h"

#include <QAction>
#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QTableView>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/Translation.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/scene/CaseFile.h"
#include "ui/document/Document.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/print/PdfPrinter.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/UseLanguage.h"
#include "ui/view/PngFile.h"
#include "ui/view/SceneView.h"

namespace vestige::cli {
namespace {

/// An overlay shows registered layers: those that lack it are registered first, by the window's own action.
Status registerLayers(MainWindow& window) {
    QAction* action = window.findChild<QAction*>("register.run");
    if (action && action->isEnabled()) action->trigger();
    const SceneState& scene = window.document().state();
    for (const Layer& layer : scene.layers)
        if (needsRegistration(scene, layer) && !layer.registration)
            return fail(ErrorCode::untrustworthy, "the layer could not be registered", "layer " + layer.id,
                        "`vestige-cli register` says why");
    return {};
}

/// As a click into the table would.
Status select(MainWindow& window, const std::string& object) {
    auto* table = window.findChild<QTableView*>("measurements");
    for (int row = 0; table && row < table->model()->rowCount(); ++row)
        if (table->model()->index(row, 0).data().toString().toStdString() == object) {
            table->selectRow(row);
            return {};
        }
    return fail(ErrorCode::usage, "the case has no object of this name", "--object " + object);
}

/// As their menus would.
Status trigger(MainWindow& window, const std::vector<std::string>& ids) {
    for (const std::string& id : ids) {
        auto* action = window.findChild<QAction*>(QString::fromStdString(id));
        if (!action) return fail(ErrorCode::usage, "the window has no action of this name", "--action " + id);
        if (!action->isEnabled())
            return fail(ErrorCode::usage, "the action is not possible now", "--action " + id,
                        "other actions before it");
        action->trigger();
        QApplication::processEvents();
    }
    return {};
}

}  // namespace

Status drawWindow(const WindowPicture& wanted) {
    useLanguage(language());
    MainWindow window(offscreenSurface(), offscreenRenderer(), std::make_unique<PdfPrinter>(), nullptr,
                      std::make_unique<InlineJobRunner>());
    window.setTheme(wanted.theme);
    // A picture has the size that was asked for, even below what is comfortable to work in.
    window.setMinimumSize(1, 1);
    window.resize(wanted.width_px, wanted.height_px);
    window.show();
    QApplication::processEvents();
    const bool isCase = wanted.inputs.size() == 1 && looksLikeCase(wanted.inputs.front());
    const Status opened = isCase ? window.openCase(wanted.inputs.front())
                                 : window.openFiles({wanted.inputs.begin(), wanted.inputs.end()});
    if (!opened) return opened;
    if (wanted.overlay == Overlay::registration || wanted.overlay == Overlay::residual)
        if (const Status registered = registerLayers(window); !registered) return registered;
    window.setOverlay(wanted.overlay);
    QApplication::processEvents();
    window.showNamedView(wanted.view);
    if (!wanted.object.empty())
        if (const Status selected = select(window, wanted.object); !selected) return selected;
    if (const Status triggered = trigger(window, wanted.actions); !triggered) return triggered;
    // Layouts and palettes settle with the events; then the points that are still to come are drawn at once.
    for (int round = 0; round < 5; ++round) QApplication::processEvents();
    window.view().completePicture();
    return writePng(window.grab().toImage().convertToFormat(QImage::Format_RGB32), wanted.png);
}

}  // namespace vestige::cli
