#pragma once

#include <QMainWindow>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/pipeline/DocumentPrinter.h"
#include "core/pipeline/ViewRenderer.h"
#include "ui/jobs/JobRunner.h"
#include "ui/view/ViewSurface.h"

namespace vestige {

class Autosave;
class Document;
class FileChooser;
class SceneView;

/// The workstation. It only assembles: what happens is in actions/reactions, panels and tools.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    /// `renderer` and `printer` make the pictures and the PDF of reports; without them these are not made.
    /// `jobs`: null for a worker thread; an InlineJobRunner where everything should be done on return.
    MainWindow(const ViewSurfaceFactory& makeSurface, std::unique_ptr<ViewRenderer> renderer,
               std::unique_ptr<DocumentPrinter> printer, QWidget* parent = nullptr,
               std::unique_ptr<JobRunner> jobs = nullptr);
    ~MainWindow() override;

    /// Replaces the case. With an inline job runner all is loaded on return and the first problem of a layer
    /// is returned; with a worker only what keeps the case from being read is.
    Status openCase(const std::filesystem::path& file);
    /// Adds clouds and meshes as layers; returns like openCase.
    Status openFiles(const std::vector<std::filesystem::path>& files);
    /// Paths of either kind, as a command line or a drop gives them; problems are told in the window.
    void open(const QStringList& paths);

    /// From now on edits are kept as they are made, cases are taken for this window, and what earlier windows
    /// left behind is offered. `folder`: the user's own, for edits that cannot be kept with their case.
    void keepEdits(const std::filesystem::path& folder);

    /// For this window alone; what the user switches is stored for the next one.
    void setTheme(Theme theme);
    void setOverlay(Overlay overlay);
    void setColorMode(ColorMode mode);
    void showNamedView(NamedView view);

    Document& document();
    SceneView& view();
    JobRunner& jobs();
    /// Null before keepEdits.
    Autosave* autosave();
    /// Answers questions for files in place of the dialogs.
    void setFileChooser(std::unique_ptr<FileChooser> chooser);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace vestige
