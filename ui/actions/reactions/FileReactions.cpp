#include "ui/actions/reactions/FileReactions.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <utility>

#include "core/scene/CaseFile.h"
#include "core/scene/SceneInputs.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/FileChooser.h"
#include "ui/document/Autosave.h"
#include "ui/document/Document.h"
#include "ui/document/Evidence.h"
#include "ui/document/Loader.h"
#include "ui/document/Notices.h"
#include "ui/document/RecentFiles.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {

FileReactions::FileReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    auto& actions = bench_.actions;
    actions.onTriggered("file.new", [this] {
        if (mayLeave()) bench_.document.replace(SceneState());
    });
    actions.onTriggered("file.open-case", [this] {
        const QString path = bench_.chooser->caseToOpen(&bench_.window);
        if (!path.isEmpty()) open({path});
    });
    actions.onTriggered("file.add-files", [this] { open(bench_.chooser->filesToAdd(&bench_.window)); });
    actions.onTriggered("file.save", [this] { save(); });
    actions.onTriggered("file.save-as", [this] { saveAs(); });
    actions.onTriggered("file.reopen", [this] {
        const auto file = bench_.document.state().file;
        if (file.empty())
            bench_.notices.inform(tr("This case was never saved, so there is nothing to reopen."));
        else if (mayLeave())
            // What goes wrong is told by the loader.
            static_cast<void>(bench_.loader.openCase(file));
    });
    actions.onTriggered("file.verify", [this] { bench_.evidence.verify(); });
    actions.onTriggered("file.quit", [this] { bench_.window.close(); });
    connect(&bench_.loader, &Loader::opened, &bench_.recent, &RecentFiles::add);
}

void FileReactions::open(const QStringList& paths) {
    std::vector<std::filesystem::path> files;
    for (const QString& path : paths) {
        if (!looksLikeCase(toPath(path))) {
            files.push_back(toPath(path));
            continue;
        }
        if (mayLeave()) static_cast<void>(bench_.loader.openCase(toPath(path)));
        return;
    }
    // What a layer's file had to say was told while loading.
    static_cast<void>(bench_.loader.addFiles(files));
}

std::filesystem::path FileReactions::place(bool another) {
    const auto& file = bench_.document.state().file;
    const bool readOnly = bench_.autosave && !bench_.autosave->readOnly().isEmpty();
    if (readOnly && !another)
        bench_.notices.inform(
            tr("This case cannot be saved here: %1. Choose another name.").arg(bench_.autosave->readOnly()));
    if (!another && !readOnly && !file.empty()) return file;
    const QString suggestion = file.empty() ? bench_.document.title() + ".vestige" : toQt(file);
    QString path = bench_.chooser->caseToSave(&bench_.window, suggestion);
    if (!path.isEmpty() && !path.contains('.')) path += ".vestige";
    return toPath(path);
}

void FileReactions::save() {
    const auto file = place(false);
    if (!file.empty()) saveTo(file, false);
}

void FileReactions::saveAs() {
    const auto file = place(true);
    if (!file.empty()) saveTo(file, false);
}

bool FileReactions::saveTo(const std::filesystem::path& file, bool wait) {
    if (!bench_.autosave) {
        const Status apart = isNoInput(bench_.document.state(), file);
        return saved(file, apart ? bench_.document.save(file) : apart);
    }
    if (wait || bench_.jobs.immediate()) return saved(file, bench_.autosave->save(file, pump()));
    bench_.autosave->saveAside(file, [this, file](const Status& status) { saved(file, status); });
    return true;
}

bool FileReactions::saved(const std::filesystem::path& file, const Status& status) {
    if (status)
        bench_.recent.add(toQt(file));
    else
        bench_.notices.failed(status.error());
    return status.has_value();
}

/// While the window waits for the disk it paints, and says what it waits for; the user cannot work in it.
std::function<void()> FileReactions::pump() {
    if (bench_.jobs.immediate()) return {};
    return [this, told = false]() mutable {
        if (!std::exchange(told, true)) bench_.notices.inform(tr("Waiting for the disk to take the case…"));
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
    };
}

bool FileReactions::mayLeave() {
    // What is being saved needs no question.
    if (bench_.autosave && bench_.autosave->saving()) bench_.autosave->awaitSaves(pump());
    if (!bench_.document.modified()) return true;
    switch (bench_.chooser->unsavedChanges(&bench_.window, bench_.document.title())) {
        case FileChooser::Unsaved::save: {
            const auto file = place(false);
            return !file.empty() && saveTo(file, true);
        }
        case FileChooser::Unsaved::discard:
            return true;
        case FileChooser::Unsaved::stay:
            break;
    }
    return false;
}

void FileReactions::leave() {
    if (bench_.autosave) bench_.autosave->end(pump());
}

}  // namespace vestige
