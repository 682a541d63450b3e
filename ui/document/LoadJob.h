#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/LoadLayers.h"
#include "core/scene/Scene.h"
#include "ui/document/CaseOpener.h"

namespace vestige {

/// What loading does on the worker's thread; Loader enters it on the GUI thread.

/// A layer whose file could not be read.
struct Unread {
    std::filesystem::path file;
    Error problem;
};

/// A layer whose file does not fit into memory.
struct TooLarge {
    Layer layer;
    LoadCheck check;
};

/// Data for a layer of the document: in the place of a preview, or the first it gets.
struct Arrival {
    Layer layer;                              ///< as it was read, without data
    std::shared_ptr<const LayerData> before;  ///< the preview; null: there was none
    std::shared_ptr<const LayerData> data;    ///< null: the file could not be read
};

/// A case as its file has it, before its layers are read.
struct OpenedCase {
    std::shared_ptr<CaseSession> session;  ///< null where edits are not kept
    SceneState saved;
    std::optional<Recovered> unsaved;  ///< what is to be put on top of it
    std::vector<std::string> remarks;
    std::optional<Error> unreadable;  ///< why there is nothing but what was recovered
};

struct Loaded {
    std::shared_ptr<const OpenedCase> opened;  ///< that the layers are of; null for files alone
    SceneState scene;                          ///< that the layers' paths belong to
    std::vector<Layer> layers;
    std::vector<TooLarge> tooLarge;
    std::vector<Unread> unread;
    std::vector<std::string> remarks;
};

/// What a job shows before it ends, in this order: layers with previews, then what comes for each.
struct Progress {
    std::shared_ptr<const OpenedCase> opened;  ///< in the first one of a case
    std::vector<Layer> layers;
    std::vector<std::string> remarks;
    std::vector<Arrival> arrivals;
};
using ShowProgress = std::function<void(Progress)>;

/// Reads the case at `file`; with an opener it is taken for this window. ErrorCode::input.
Result<OpenedCase> openCase(const std::optional<CaseOpener>& opener, const std::filesystem::path& file);

/// The case that something left behind belongs to; where that is gone or cannot be read, a case without a
/// place that takes it over. ErrorCode::input where that cannot be read either.
Result<OpenedCase> openAbandoned(const std::optional<CaseOpener>& opener, const Abandoned& abandoned);

/// What reading the layers of a case begins with: those of the saved case, and those of what is put on top.
Loaded layersToRead(OpenedCase opened);

/// Gives a preview to each layer that has no data and whose file takes long to read; false when none has one.
bool lookAt(const SceneState& scene, std::vector<Layer>& layers, const JobControl& control);

/// Reads every layer that has no data or a preview; what cannot be read or does not fit is noted and stays
/// without. `arrived` hears of each as it comes. ErrorCode::cancelled.
Status readAll(Loaded& loaded, const std::function<void(const Arrival&)>& arrived, const JobControl& control);

/// For files added without a case: previews are named and shown at once; what is left in the result are the
/// layers of the other files, named after them.
Result<Loaded> readFiles(Loaded request, const ShowProgress& show, const JobControl& control);

/// For a case: with previews among its layers all of it is shown at once, and each layer's data as they come;
/// else everything is in the result.
Result<Loaded> readCaseLayers(Loaded request, const ShowProgress& show, const JobControl& control);

}  // namespace vestige
