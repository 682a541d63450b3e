#include "ui/actions/reactions/FileReactions.h"

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
            told(bench_.loader.openCase(file));
    });
    actions.onTriggered("file.verify", [this] { bench_.evidence.verify(); });
    actions.onTriggered("file.quit", [this] { bench_.window.close(); });
    connect(&bench_.loader, &Loader::opened, &bench_.recent, &RecentFiles::add);
}

void FileReactions::told(const Status& status) {
    if (!status) bench_.notices.failed(status.error());
}

void FileReactions::open(const QStringList& paths) {
    std::vector<std::filesystem::path> files;
    for (const QString& path : paths) {
        if (!looksLikeCase(toPath(path))) {
            files.push_back(toPath(path));
            continue;
        }
        if (mayLeave()) told(bench_.loader.openCase(toPath(path)));
        return;
    }
    // What a layer's file had to say was told while loading.
    static_cast<void>(bench_.loader.addFiles(files));
}

bool FileReactions::save() {
    const auto& file = bench_.document.state().file;
    if (bench_.autosave && !bench_.autosave->readOnly().isEmpty()) {
        bench_.notices.inform(
            tr("This case cannot be saved here: %1. Choose another name.").arg(bench_.autosave->readOnly()));
        return saveAs();
    }
    return file.empty() ? saveAs() : saveTo(file);
}

bool FileReactions::saveAs() {
    const auto& file = bench_.document.state().file;
    const QString suggestion = file.empty() ? bench_.document.title() + ".vestige" : toQt(file);
    QString path = bench_.chooser->caseToSave(&bench_.window, suggestion);
    if (path.isEmpty()) return false;
    if (!path.contains('.')) path += ".vestige";
    return saveTo(toPath(path));
}

bool FileReactions::saveTo(const std::filesystem::path& file) {
    if (const Status apart = isNoInput(bench_.document.state(), file); !apart) {
        told(apart);
        return false;
    }
    const Status saved = bench_.autosave ? bench_.autosave->save(file) : bench_.document.save(file);
    told(saved);
    if (saved) bench_.recent.add(toQt(file));
    return saved.has_value();
}

bool FileReactions::mayLeave() {
    if (!bench_.document.modified()) return true;
    switch (bench_.chooser->unsavedChanges(&bench_.window, bench_.document.title())) {
        case FileChooser::Unsaved::save:
            return save();
        case FileChooser::Unsaved::discard:
            return true;
        case FileChooser::Unsaved::stay:
            break;
    }
    return false;
}

}  // namespace vestige
