#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/LoadLayers.h"
#include "core/scene/Scene.h"

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

struct Loaded {
    SceneState scene;  ///< that the layers' paths belong to
    std::vector<Layer> layers;
    std::vector<TooLarge> tooLarge;
    std::vector<Unread> unread;
    std::vector<std::string> remarks;
};

/// What a job shows before it ends, in this order: layers with previews, then what comes for each.
struct Progress {
    std::vector<Layer> layers;
    std::vector<std::string> remarks;
    std::vector<Arrival> arrivals;
};
using ShowProgress = std::function<void(Progress)>;

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
