#include "core/pipeline/LoadLayers.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <future>
#include <string_view>
#include <utility>

#include "core/base/FileStamp.h"
#include "core/base/Hash.h"
#include "core/io/ApplyReadOptions.h"
#include "core/io/FormatRegistry.h"
#include "core/io/InputHash.h"
#include "core/scene/CleanedData.h"

namespace vestige {
namespace {

/// A file of fewer points is read in about the time of a first look.
constexpr std::uint64_t kPreviewFrom = 4'000'000;
constexpr std::size_t kPreviewPoints = 1'500'000;

/// The hash of a file, computed while it is read.
class HashMeanwhile {
  public:
    explicit HashMeanwhile(const std::filesystem::path& file)
        : hash_(std::async(std::launch::async,
                           [file, control = control_] { return sha256OfFile(file, control); })) {}
    ~HashMeanwhile() { control_.cancel(); }
    HashMeanwhile(const HashMeanwhile&) = delete;
    HashMeanwhile& operator=(const HashMeanwhile&) = delete;
    /// Waits for it, but no longer than until `control` is cancelled.
    Result<std::string> take(const JobControl& control) {
        while (hash_.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
            if (control.cancelled()) control_.cancel();
        return hash_.get();
    }

  private:
    JobControl control_;
    std::future<Result<std::string>> hash_;
};

std::shared_ptr<LayerData> withIndex(LoadedGeometry loaded) {
    auto data = std::make_shared<LayerData>();
    data->geometry = std::make_shared<const TriangleMesh>(std::move(loaded.geometry));
    data->points = std::shared_ptr<const PointCloud>(data->geometry, &data->geometry->vertices);
    data->octree = std::make_shared<const Octree>(data->points);
    data->info = std::move(loaded.info);
    return data;
}

/// The share of a file's ground plan that a box covers.
double coveredShare(const BoundingBox& bounds, const BoundingBox& box) {
    double share = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double whole = bounds.max[axis] - bounds.min[axis];
        const double common =
            std::min(bounds.max[axis], box.max[axis]) - std::max(bounds.min[axis], box.min[axis]);
        if (common < 0) return 0;
        if (whole > 0) share *= std::min(1.0, common / whole);
    }
    return share;
}

}  // namespace

ReadOptions readOptionsOf(const Layer& layer) {
    ReadOptions options;
    options.attributes = ReadOptions::Attributes::drawn;
    options.keepEvery = layer.keepEvery;
    options.box = layer.box;
    options.salvage = layer.salvage;
    return options;
}

Result<LoadCheck> checkLoad(const std::filesystem::path& file, const ReadOptions& options, LoadedFor use,
                            const JobControl& control) {
    auto peeked = peekFile(file, control);
    if (!peeked) return fail(peeked.error());
    FileInfo asked = *peeked;
    if (options.box && !asked.bounds.empty())
        asked.points = static_cast<std::uint64_t>(static_cast<double>(asked.points) *
                                                  coveredShare(asked.bounds, *options.box));
    return LoadCheck{std::move(*peeked), estimateLoad(asked, options, use)};
}

Error tooLarge(const std::filesystem::path& file, const LoadEstimate& estimate, const std::string& offer) {
    return {ErrorCode::input, estimate.sentence(), file.string(), offer};
}

std::string commandLineOffer(const LoadEstimate& estimate) {
    if (!estimate.partsHelp)
        return "this format is read whole before a part is taken; expected: more memory, or the file as LAS "
               "or LAZ";
    const std::string every = std::to_string(estimate.keepEveryToFit);
    return "--every " + every + " takes every " + every +
           "th point, --box xmin,ymin,zmin,xmax,ymax,zmax a part; a case says \"keep_every\" or \"box\" of a "
           "layer";
}

Result<std::shared_ptr<const LayerData>> loadLayerData(const std::filesystem::path& file,
                                                       const ReadOptions& options,
                                                       const JobControl& control) {
    return guarded(file.string(), [&]() -> Result<std::shared_ptr<const LayerData>> {
        const auto before = stampOf(file);
        if (!before) return fail(before.error());
        HashMeanwhile hash(file);
        auto loaded = readGeometry(file, options, control.sub(0, 0.6));
        if (!loaded) return fail(loaded.error());
        if (control.cancelled()) return fail(cancelledError());
        control.progress(0.6, "index of " + file.filename().string());
        const std::shared_ptr<LayerData> data = withIndex(std::move(*loaded));
        if (control.cancelled()) return fail(cancelledError());
        auto sha256 = hash.take(control);
        if (!sha256) return fail(sha256.error());
        // The hash is of these points only if nobody has written in between.
        if (const auto after = stampOf(file); !after || *after != *before)
            return fail(changedWhileRead(file, *before));
        data->stamp = *before;
        auto input = hashInput(file, *sha256, data->info.companions, control);
        if (!input) return fail(input.error());
        if (const Status same = companionsAsRead(data->info); !same) return fail(same.error());
        data->sha256 = std::move(input->sha256);
        data->companionSha256 = std::move(input->companions);
        control.progress(1);
        return std::shared_ptr<const LayerData>(data);
    });
}

Result<std::shared_ptr<const LayerData>> loadLayer(const Layer& layer, const std::filesystem::path& file,
                                                   const JobControl& control) {
    const ReadOptions options = readOptionsOf(layer);
    const auto check = checkLoad(file, options);
    if (!check) return fail(check.error());
    if (!check->estimate.fits())
        return fail(tooLarge(file, check->estimate, commandLineOffer(check->estimate)));
    auto data = loadLayerData(file, options, control.sub(0, layer.cleaning ? 0.8 : 1));
    if (!data || !layer.cleaning) return data;
    Layer loaded = layer;
    loaded.data = std::move(*data);
    if (const Status cleaned = applyCleaning(loaded, control.sub(0.8, 1)); !cleaned)
        return fail(cleaned.error());
    return loaded.data;
}

Result<std::shared_ptr<const LayerData>> previewLayerData(const std::filesystem::path& file,
                                                          const LoadCheck& check, const ReadOptions& options,
                                                          const JobControl& control) {
    return guarded(file.string(), [&]() -> Result<std::shared_ptr<const LayerData>> {
        if (check.peeked.points < kPreviewFrom) return std::shared_ptr<const LayerData>();
        const auto stamp = stampOf(file);
        if (!stamp) return fail(stamp.error());
        auto look = previewFile(file, kPreviewPoints, control);
        if (!look) return fail(look.error());
        if (!*look || control.cancelled()) return std::shared_ptr<const LayerData>();
        ReadOptions box;
        box.attributes = options.attributes;
        box.box = options.box;
        (*look)->heeded = false;
        applyReadOptions(box, **look);
        if ((*look)->geometry.vertices.empty()) return std::shared_ptr<const LayerData>();
        const std::shared_ptr<LayerData> data = withIndex(std::move(**look));
        data->awaitedPoints = std::max<std::uint64_t>(1, check.estimate.points);
        data->stamp = *stamp;
        return std::shared_ptr<const LayerData>(data);
    });
}

Result<std::shared_ptr<const PointCloud>> allAttributes(const Layer& layer, const std::filesystem::path& file,
                                                        const JobControl& control) {
    constexpr std::array<std::string_view, 4> kDrawn{"intensity", "color", "normals", "classification"};
    const std::vector<std::string>& names = layer.data->info.attributes;
    const bool complete = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
        return std::find(kDrawn.begin(), kDrawn.end(), name) != kDrawn.end();
    });
    const PointAttributes& held = layer.data->points->attributes();
    const bool whole = !held.gpsTime.empty() || !held.pointSource.empty() || !held.returnNumber.empty() ||
                       !held.returnCount.empty();
    if (complete || whole) return layer.data->points;
    const auto isAsRead = [&] {
        const auto now = stampOf(file);
        return now && *now == layer.data->stamp && companionsAsRead(layer.data->info);
    };
    const Error changed{ErrorCode::input, "the file has changed since its points were read", file.string(),
                        "it must not change while it is worked with; read it again"};
    if (!isAsRead()) return fail(changed);
    ReadOptions options = readOptionsOf(layer);
    options.attributes = ReadOptions::Attributes::all;
    if (const auto check = checkLoad(file, options, LoadedFor::command); check && !check->estimate.fits())
        return fail(
            tooLarge(file, check->estimate,
                     "all attributes of its points are wanted, beside what is held of them; expected: "
                     "more free memory, or a layer that is thinned or a part (\"keep_every\", "
                     "\"box\" in the case)"));
    auto loaded = readGeometry(file, options, control);
    if (!loaded) return fail(loaded.error());
    if (!isAsRead() || loaded->geometry.vertices.size() != layer.data->points->size()) return fail(changed);
    return std::make_shared<const PointCloud>(std::move(loaded->geometry.vertices));
}

}  // namespace vestige
