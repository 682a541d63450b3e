#pragma once

#include <QStringList>

class QWidget;

namespace vestige {

/// Asks the user for files and folders. A virtual class, so that a program or test can answer in its place.
class FileChooser {
  public:
    virtual ~FileChooser() = default;
    /// Empty answers mean that the user thought better of it.
    virtual QString caseToOpen(QWidget* window);
    virtual QStringList filesToAdd(QWidget* window);
    virtual QString caseToSave(QWidget* window, const QString& suggestion);
    virtual QString csvToSave(QWidget* window, const QString& suggestion);
    /// A text table: picks, tape values.
    virtual QString tableToOpen(QWidget* window, const QString& title);
    /// PDF, HTML or text.
    virtual QString sheetToSave(QWidget* window, const QString& suggestion);
    virtual QString pictureToSave(QWidget* window, const QString& suggestion);
    virtual QString folderForReport(QWidget* window, const QString& suggestion);
    enum class Unsaved { save, discard, stay };
    virtual Unsaved unsavedChanges(QWidget* window, const QString& title);
};

}  // namespace vestige
