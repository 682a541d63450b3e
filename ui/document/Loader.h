#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/Scene.h"
#include "ui/document/CaseOpener.h"
#include "ui/document/Notices.h"

namespace vestige {

class Autosave;
class Document;
class JobRunner;
struct Arrival;
struct Loaded;
struct OpenedCase;
struct Progress;
struct TooLarge;

/// Brings cases and files into the document: reads on the job runner, enters the result on the GUI thread. Of
/// large files some points are shown while the rest is read. Files that do not fit into memory are told with
/// offers to load a part.
class Loader : public QObject {
    Q_OBJECT

  public:
    Loader(Document& document, JobRunner& jobs, Notices& notices, QObject* parent = nullptr);

    /// Replaces the document by the case in `file`. A layer that cannot be read stays in the case without
    /// data and is told, as what keeps the case from being opened. With an inline runner everything is loaded
    /// on return and the first error is returned, too.
    Status openCase(const std::filesystem::path& file);
    /// Opens what a window left behind that is gone: the case it belongs to, else (it is gone, or cannot be
    /// read) a case without a place. What fails is told; `done` hears whether a case was opened.
    void recover(const Abandoned& abandoned, std::function<void(bool)> done = {});
    /// What windows that are gone left behind; nothing without an autosave.
    void findAbandoned(std::function<void(std::vector<Abandoned>)> found);
    /// Cases are then taken for this window, and edits that were not saved come back as a step that can be
    /// undone.
    void setAutosave(Autosave* autosave) { autosave_ = autosave; }
    /// Adds clouds and meshes as layers, in one step of the history (large ones in one before the others).
    /// Returns like openCase. Cancelled, the layers are taken back. Of a damaged file it is offered to load
    /// what is whole, which `salvage` does at once.
    Status addFiles(const std::vector<std::filesystem::path>& files, bool salvage = false);

  signals:
    /// A case was opened, or files were added.
    void opened(const QString& path);
    /// Edits that were not saved came back with the case.
    void recovered(const QString& sentence);

  private:
    std::optional<CaseOpener> opener() const;
    Status load(const QString& title, std::function<Result<OpenedCase>()> open,
                std::function<void(bool)> ended = {});
    void put(const OpenedCase& opened, const std::vector<Layer>& read, bool edited);
    void tellUnreadable(Error error);
    void tellDifferences();
    void add(std::vector<Layer> layers);
    void readAgain(const Layer& layer);
    void enter(const std::vector<Layer>& layers);
    void take(const std::vector<Arrival>& arrivals);
    void place();
    void dropPreviews();
    void remark(const std::vector<std::string>& remarks);
    void tell(const Error& error);
    void tellStopped(const Error& error);
    /// Of files; `offering`: what is whole of a damaged one is to be added.
    void tell(const Loaded& loaded, bool added);
    /// Layers of the case that were not read because their file is damaged: with what is whole, from now on.
    void salvage(const std::filesystem::path& file);
    static QString sentenceOn(const TooLarge& large);
    /// What can be loaded of it; `oneOfMany`: the offers name the file.
    void addOffers(const TooLarge& large, bool oneOfMany, std::vector<Notices::Offer>& offers);

    Document& document_;
    JobRunner& jobs_;
    Notices& notices_;
    Autosave* autosave_ = nullptr;
    std::vector<Error> problems_;  ///< of the job that was delivered last
    int replacements_ = 0;         ///< of the document: what was asked for an earlier one is not entered
    std::vector<std::shared_ptr<const LayerData>> previews_;  ///< shown, their whole is awaited
    std::vector<Layer> unplaced_;                             ///< read, and nobody asks for it at present
};

}  // namespace vestige
