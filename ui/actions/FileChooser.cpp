#include "ui/actions/FileChooser.h"

#include <QFileDialog>
#include <QMessageBox>

#include "core/io/FormatRegistry.h"
#include "ui/actions/FilePeekPanel.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

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
        filters << said(format->title()) + " (" + patterns.join(' ') + ")";
    }
    return QObject::tr("All scans") + " (" + every.join(' ') + ");;" + filters.join(";;") + ";;" +
           QObject::tr("All files") + " (*)";
}

}  // namespace

QString FileChooser::caseToOpen(QWidget* window) {
    return QFileDialog::getOpenFileName(
        window, QObject::tr("Open case"), {},
        QObject::tr("Cases") + " (*.vestige *.json);;" + QObject::tr("All files") + " (*)");
}

QStringList FileChooser::filesToAdd(QWidget* window) {
    QFileDialog dialog(window, QObject::tr("Add clouds and meshes"), {}, readableFilter());
    dialog.setFileMode(QFileDialog::ExistingFiles);
    addPeekPanel(dialog);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles() : QStringList();
}

QString FileChooser::caseToSave(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, QObject::tr("Save case"), suggestion,
                                        QObject::tr("Vestige case") + " (*.vestige);;JSON (*.json)");
}

QString FileChooser::csvToSave(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, QObject::tr("Export as CSV"), suggestion, "CSV (*.csv)");
}

QString FileChooser::tableToOpen(QWidget* window, const QString& title) {
    return QFileDialog::getOpenFileName(window, title, {},
                                        QObject::tr("Tables") + " (*.csv *.txt *.tsv *.asc *.xyz *.pts);;" +
                                            QObject::tr("All files") + " (*)");
}

QString FileChooser::sheetToSave(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, QObject::tr("Save shortcut sheet"), suggestion,
                                        "PDF (*.pdf);;HTML (*.html);;" + QObject::tr("Text") + " (*.txt)");
}

QString FileChooser::pictureToSave(QWidget* window, const QString& suggestion) {
    return QFileDialog::getSaveFileName(window, QObject::tr("Save picture"), suggestion, "PNG (*.png)");
}

QString FileChooser::folderForReport(QWidget* window, const QString& suggestion) {
    return QFileDialog::getExistingDirectory(window, QObject::tr("Folder for the report"), suggestion);
}

FileChooser::Unsaved FileChooser::unsavedChanges(QWidget* window, const QString& title) {
    const auto answer = QMessageBox::question(
        window, QObject::tr("Unsaved changes"), QObject::tr("Save the changes of \"%1\" first?").arg(title),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (answer == QMessageBox::Save) return Unsaved::save;
    return answer == QMessageBox::Discard ? Unsaved::discard : Unsaved::stay;
}

}  // namespace vestige
