#include "ui/shell/RecentMenu.h"

#include "ui/document/RecentFiles.h"

namespace vestige {

RecentMenu::RecentMenu(RecentFiles& recent, QWidget* parent)
    : QMenu(tr("Open recen&t"), parent), recent_(recent) {
    connect(&recent_, &RecentFiles::changed, this, [this] { fill(); });
    fill();
}

void RecentMenu::fill() {
    clear();
    const QStringList paths = recent_.paths();
    menuAction()->setEnabled(!paths.isEmpty());
    for (const QString& path : paths)
        connect(addAction(path), &QAction::triggered, this, [this, path] { emit chosen(path); });
    addSeparator();
    connect(addAction(tr("&Clear the list")), &QAction::triggered, &recent_, &RecentFiles::clear);
}

}  // namespace vestige
