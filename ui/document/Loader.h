#pragma once

#include <QObject>
#include <filesystem>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

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
    /// Adds clouds and meshes as layers, in one step of the history. Returns like openCase. Of a damaged file
    /// it is offered to load what is whole, which `salvage` does at once.
    Status addFiles(const std::vector<std::filesystem::path>& files, bool salvage = false);

  signals:
    /// A case was opened, or files were added.
    void opened(const QString& path);

  private:
    void enter(const std::vector<Layer>& layers);
    void remark(const std::vector<std::string>& remarks);
    void tell(const std::vector<Error>& problems);
    /// The same of files that were to be added; problems and files in the same order.
    void tellOfFiles(const std::vector<Error>& problems, const std::vector<std::filesystem::path>& files);

    Document& document_;
    JobRunner& jobs_;
    Notices& notices_;
    std::vector<Error> problems_;  ///< of the job that was delivered last
};

}  // namespace vestige
