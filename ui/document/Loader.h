#pragma once

#include <QObject>
#include <filesystem>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"
#include "core/scene/store/CaseSession.h"

namespace vestige {

class Autosave;
class Document;
class JobRunner;
class Notices;

/// Brings cases and files into the document: reads on the job runner, enters the result on the GUI thread.
class Loader : public QObject {
    Q_OBJECT

  public:
    Loader(Document& document, JobRunner& jobs, Notices& notices, QObject* parent = nullptr);

    /// Replaces the document by the case in `file`. A layer that cannot be read stays in the case without
    /// data and is told; the error of an unreadable case is returned at once. With an inline runner
    /// everything is loaded on return and the first error of a layer is returned, too.
    Status openCase(const std::filesystem::path& file);
    /// Opens what a window left behind that is gone: the case it belongs to, else a case without a place.
    Status recover(const Abandoned& abandoned);
    /// Cases are then taken for this window, and edits that were not saved come back as a step that can be
    /// undone.
    void setAutosave(Autosave* autosave) { autosave_ = autosave; }
    /// Adds clouds and meshes as layers, in one step of the history. Returns like openCase.
    Status addFiles(const std::vector<std::filesystem::path>& files);

  signals:
    /// A case was opened, or files were added.
    void opened(const QString& path);
    /// Edits that were not saved came back with the case.
    void recovered(const QString& sentence);

  private:
    Status load(std::shared_ptr<CaseSession> session, SceneState saved,
                const std::vector<std::string>& remarks);
    void enter(const std::vector<Layer>& layers);
    void remark(const std::vector<std::string>& remarks);
    void tell(const std::vector<Error>& problems);

    Document& document_;
    JobRunner& jobs_;
    Notices& notices_;
    Autosave* autosave_ = nullptr;
    std::vector<Error> problems_;  ///< of the job that was delivered last
};

}  // namespace vestige
