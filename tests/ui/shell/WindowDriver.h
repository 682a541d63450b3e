#pragma once

#include <Eigen/Core>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>

#include "core/scene/Scene.h"
#include "ui/actions/FileChooser.h"
#include "ui/shell/MainWindow.h"

namespace vestige::test {

/// Answers for the file dialogs.
class PreparedAnswers : public FileChooser {
  public:
    QString caseToOpen(QWidget*) override { return casePath; }
    QStringList filesToAdd(QWidget*) override { return files; }
    QString caseToSave(QWidget*, const QString&) override { return casePath; }
    QString csvToSave(QWidget*, const QString&) override { return csv; }
    QString tableToOpen(QWidget*, const QString&) override { return table; }
    QString sheetToSave(QWidget*, const QString&) override { return sheet; }
    QString folderForReport(QWidget*, const QString&) override { return folder; }
    Unsaved unsavedChanges(QWidget*, const QString&) override { return unsaved; }

    QString pictureToSave(QWidget*, const QString&) override { return picture; }

    QString casePath, csv, folder, table, sheet, picture;
    QStringList files;
    Unsaved unsaved = Unsaved::discard;
};

/// A window and the hand that works it, by actions' ids, mouse and keys.
class WindowDriver {
  public:
    explicit WindowDriver(std::unique_ptr<MainWindow> window);
    ~WindowDriver();

    MainWindow& window() { return *window_; }
    PreparedAnswers& answers() { return *answers_; }
    const SceneState& scene() const;

    /// Triggers an action as its menu would; false when it is disabled.
    bool trigger(const char* id);
    bool enabled(const char* id) const;
    QString textOf(const char* id) const;
    /// Waits until no job runs; false when one still does after `seconds`.
    bool settle(int seconds = 120);
    /// Clicks the view where the camera shows the point.
    void clickOn(const Eigen::Vector3d& world);
    /// Types into a cell of the measurements table as a person does: double click, text, Return.
    void typeInto(int row, int column, const QString& text);
    /// What a label of that name says.
    QString label(const char* objectName) const;

  private:
    PreparedAnswers* answers_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace vestige::test
