#include "ui/shell/WindowReactions.h"

#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QTableView>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/FileChooser.h"
#include "ui/actions/ShortcutSheet.h"
#include "ui/document/Notices.h"
#include "ui/document/Wording.h"
#include "ui/panels/TableText.h"
#include "ui/shell/SideDock.h"
#include "ui/view/SceneView.h"

namespace vestige {

WindowReactions::WindowReactions(QMainWindow& window, const Workbench& bench, SceneView& view,
                                 QObject* parent)
    : QObject(parent), window_(window), bench_(bench), view_(view), shortcuts_(bench.actions) {
    auto& actions = bench_.actions;
    actions.onTriggered("edit.copy-view", [this] { copyView(); });
    actions.onTriggered("edit.copy-table", [this] { copyTable(); });
    actions.onToggled("view.full-screen", [this](bool on) { fillScreen(on); });
    actions.onTriggered("help.guide", [this] { dock().showGuide(); });
    actions.onTriggered("help.tutorial", [this] { dock().showTutorial(); });
    actions.onTriggered("help.shortcuts", [this] { dock().showShortcuts(); });
    actions.onTriggered("help.shortcut-sheet", [this] { saveSheet(); });
}

SideDock& WindowReactions::dock() {
    if (!dock_) {
        dock_ = new SideDock(bench_.actions, shortcuts_, &window_);
        window_.addDockWidget(Qt::RightDockWidgetArea, dock_);
        window_.resizeDocks({dock_}, {360}, Qt::Horizontal);
    }
    return *dock_;
}

void WindowReactions::copyView() {
    view_.completePicture();
    const QImage picture = view_.grab();
    if (picture.isNull()) return bench_.notices.inform(tr("There is no picture yet: add scans first."));
    QApplication::clipboard()->setImage(picture);
    bench_.notices.inform(
        tr("The view is on the clipboard, %1 × %2 pixels.").arg(picture.width()).arg(picture.height()));
}

void WindowReactions::copyTable() {
    auto* focused = qobject_cast<QAbstractItemView*>(QApplication::focusWidget());
    const QAbstractItemView* table = focused ? focused : window_.findChild<QTableView*>("measurements");
    if (!table || !table->model() || table->model()->rowCount() == 0)
        return bench_.notices.inform(tr("There is nothing to copy: the table is empty."));
    const QString text = tableText(*table, focused == nullptr);
    QApplication::clipboard()->setText(text);
    const bool headed = table->inherits("QTableView");
    bench_.notices.inform(tr("%1 rows are on the clipboard.").arg(text.count('\n') - (headed ? 1 : 0)));
}

void WindowReactions::fillScreen(bool on) {
    window_.setWindowState(on ? window_.windowState() | Qt::WindowFullScreen
                              : window_.windowState() & ~Qt::WindowFullScreen);
}

void WindowReactions::saveSheet() {
    QString file = bench_.chooser->sheetToSave(&bench_.window, tr("Vestige shortcuts") + ".pdf");
    if (file.isEmpty()) return;
    if (!file.contains('.')) file += ".pdf";
    const Status written = writeShortcutSheet(bench_.actions, file);
    if (!written) return bench_.notices.failed(written.error());
    bench_.notices.informOf(tr("The shortcuts are in %1.").arg(toQt(toPath(file).filename())), file);
}

}  // namespace vestige
