#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/io/LoadEstimate.h"
#include "core/scene/Scene.h"

namespace vestige {

/// What of a layer's file is loaded: the part that the case names, without the attributes that nothing but
/// exports asks for (see allAttributes).
ReadOptions readOptionsOf(const Layer& layer);

/// What a file says of itself before it is read, and what loading it takes.
struct LoadCheck {
    FileInfo peeked;
    LoadEstimate estimate;
};
/// Fails only where the file cannot be looked into; whether it fits is in the estimate. Of a box, the share
/// of the file's ground plan is taken.
Result<LoadCheck> checkLoad(const std::filesystem::path& file, const ReadOptions& options,
                            LoadedFor use = LoadedFor::scene, const JobControl& control = {});
/// What refuses a file that does not fit, with what can be done: ErrorCode::input. `offer` says how.
Error tooLarge(const std::filesystem::path& file, const LoadEstimate& estimate, const std::string& offer);
/// The offer on a command line: "--every 4 loads every 4th point, --box ... a part"; or, of a format whose
/// parts take the memory of the whole, what else to do.
std::string commandLineOffer(const LoadEstimate& estimate);

/// Reads a part of one file, hashes the file meanwhile, and builds the octree; any thread. Does not ask
/// whether there is memory for it.
Result<std::shared_ptr<const LayerData>> loadLayerData(const std::filesystem::path& file,
                                                       const ReadOptions& options, const JobControl& control);
/// checkLoad() and loadLayerData() of a layer whose file is `file`, cleaned as the case says; refused with
/// the command line's offer.
Result<std::shared_ptr<const LayerData>> loadLayer(const Layer& layer, const std::filesystem::path& file,
                                                   const JobControl& control);

/// A first look at a file that takes long to read: some of its points, with an octree. Null for a file of few
/// points and for formats that cannot tell quickly.
Result<std::shared_ptr<const LayerData>> previewLayerData(const std::filesystem::path& file,
                                                          const LoadCheck& check, const ReadOptions& options,
                                                          const JobControl& control);

/// The layer's points with everything the file has of them, read again from `file` unless they have it
/// already; as many as the layer's and in their order. ErrorCode::input when the file has changed so that
/// they are not.
Result<std::shared_ptr<const PointCloud>> allAttributes(const Layer& layer, const std::filesystem::path& file,
                                                        const JobControl& control);

}  // namespace vestige
