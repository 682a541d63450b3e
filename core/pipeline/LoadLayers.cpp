#include "core/pipeline/LoadLayers.h"

#include "core/base/FileStamp.h"
#include "core/base/Hash.h"
#include "core/io/FormatRegistry.h"

namespace vestige {

Result<std::shared_ptr<const LayerData>> loadLayerData(const std::filesystem::path& file,
                                                       const JobControl& control, bool salvage) {
    return guarded(file.string(), [&]() -> Result<std::shared_ptr<const LayerData>> {
        const auto before = stampOf(file);
        if (!before) return fail(before.error());
        auto hash = sha256OfFile(file, control.sub(0, 0.15));
        if (!hash) return fail(hash.error());
        ReadOptions options;
        options.salvage = salvage;
        auto loaded = readGeometry(file, options, control.sub(0.15, 0.7));
        if (!loaded) return fail(loaded.error());
        // The hash is of these points only if nobody has written in between.
        if (const auto after = stampOf(file); !after || *after != *before)
            return fail(changedWhileRead(file, *before));
        if (control.cancelled()) return fail(cancelledError());
        auto data = std::make_shared<LayerData>();
        data->geometry = std::make_shared<const TriangleMesh>(std::move(loaded->geometry));
        data->points = std::shared_ptr<const PointCloud>(data->geometry, &data->geometry->vertices);
        control.progress(0.7, "index of " + file.filename().string());
        data->octree = std::make_shared<const Octree>(data->points);
        data->info = std::move(loaded->info);
        data->sha256 = std::move(*hash);
        data->stamp = *before;
        if (control.cancelled()) return fail(cancelledError());
        control.progress(1);
        return std::shared_ptr<const LayerData>(std::move(data));
    });
}

}  // namespace vestige
