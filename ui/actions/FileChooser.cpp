#include "ui/actions/FileChooser.h"

#include <QFileDialog>
#include <QMessageBox>

#include "core/io/FormatRegistry.h"
#include "ui/actions/FilePeekPanel.h"

namespace vestige {
namespace {

QString tr(const char* text) {
    return QObject::tr(text);
}

/// "All scans (*.las ...);;LAS point cloud (*.las);;..." from the registry.
QString readableFilter() {
    QStringList every, filters;
    for (const auto& format : fileFormats()) {
        if (!format->canRead()) continue;
        QStringList patterns;
        for (const auto& extension : format->extensions()) {
            const QString pattern = QString::fromStdString(extension);
            patterns << "*." + pattern << "*." + pattern.toUpper();
        }
        every << patterns;
        const auto title = format->title();
        filters << QString::fromUtf8(title.data(), static_cast<int>(title.size())) + " (" +
                       patterns.join(' ') + ")";
    }
    return tr("All scans") + " (" + every.join(' ') + ");;" + filters.join(";;") + ";;" + tr("All files") +
           " (*)";
}

}  // namespace

QString FileChooser::caseToOpen(QWidget* window) {
    return QFileDialog::getOpenFileName(window, tr("Open case"), {},
                                        tr("Cases") + " (*.vestige *.json);;" + tr("All files") + " (*)");
}

QStringList FileChooser::filesToAdd(QWidget* window) {
    QFileDialog dialog(window, tr("Add clouds and meshes"), {}, readableFilter());
    dialog.setFileMode(QFileDialog::ExistingFiles);
    addPeekPanel(dialog);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles() : QStringList();
}

QString FileChooser::caseToSave(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, tr("Save case"), suggestion,
                                        tr("Vestige case") + " (*.vestige);;JSON (*.json)");
}

QString FileChooser::csvToSave(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, tr("Export measurements"), suggestion, "CSV (*.csv)");
}

QString FileChooser::pictureToSave(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, tr("Save picture"), suggestion, "PNG (*.png)");
}

QString FileChooser::folderForReport(QWidget* window, const QString& suggestion) {
    return QFileDialog::getExistingDirectory(window, tr("Folder for the report"), suggestion);
}

FileChooser::Unsaved FileChooser::unsavedChanges(QWidget* window, const QString& title) {
    const auto answer = QMessageBox::question(
        window, tr("Unsaved changes"), tr("Save the changes of \"%1\" first?").arg(title),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) return Unsaved::save;
    return answer == QMessageBox::Discard ? Unsaved::discard : Unsaved::stay;
}

}  // namespace vestige
