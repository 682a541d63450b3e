#pragma once

#include <filesystem>
#include <memory>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Reads and hashes one file and builds its octree; any thread. `salvage` as in ReadOptions.
Result<std::shared_ptr<const LayerData>> loadLayerData(const std::filesystem::path& file,
                                                       const JobControl& control, bool salvage = false);

}  // namespace vestige
