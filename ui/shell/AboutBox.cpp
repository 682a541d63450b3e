#include "ui/shell/AboutBox.h"

#include <QMessageBox>

#include "core/base/Version.h"

namespace vestige {

void showAbout(QWidget* window) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, QObject::tr("About Vestige"),
                                QObject::tr("<b>Vestige %1</b>").arg(kVersion), QMessageBox::Close, window);
    box->setInformativeText(QObject::tr(
        "Rebuilds road-accident scenes from aerial and handheld laser scans and measures them.\n\n"
        "The method: Zhang, Guan, Liu, Zhang, World Electr. Veh. J. 2025, 16(3), 171."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace vestige
