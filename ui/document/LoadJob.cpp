#include "ui/document/LoadJob.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/document/LayerDefaults.h"

namespace vestige {

bool lookAt(const SceneState& scene, std::vector<Layer>& layers, const JobControl& control) {
    bool any = false;
    for (Layer& layer : layers) {
        if (layer.data || control.cancelled()) continue;
        const auto file = scene.resolve(layer.path);
        const ReadOptions options = readOptionsOf(layer);
        // What goes wrong here goes wrong when the whole is read, and is told then.
        const auto check = checkLoad(file, options);
        if (!check || !check->estimate.fits()) continue;
        const auto preview = previewLayerData(file, *check, options, {});
        if (!preview || !*preview) continue;
        layer.data = *preview;
        any = true;
    }
    return any;
}

Status readAll(Loaded& loaded, const std::function<void(const Arrival&)>& arrived,
               const JobControl& control) {
    const auto count = static_cast<double>(loaded.layers.size());
    for (std::size_t i = 0; i < loaded.layers.size(); ++i) {
        Layer& layer = loaded.layers[i];
        if (layer.data && !layer.data->isPreview()) continue;
        const auto step = control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        step.progress(0, "Reading " + layer.path.filename().string());
        const auto file = loaded.scene.resolve(layer.path);
        const ReadOptions options = readOptionsOf(layer);
        Arrival arrival{layer, std::exchange(layer.data, nullptr), nullptr};
        arrival.layer.data = nullptr;
        const auto check = checkLoad(file, options, LoadedFor::scene, step);
        if (!check) {
            loaded.unread.push_back({layer.path, check.error()});
        } else if (!check->estimate.fits()) {
            loaded.tooLarge.push_back({layer, *check});
        } else {
            auto data = loadLayerData(file, options, step);
            if (!data && data.error().code == ErrorCode::cancelled) return fail(data.error());
            if (data) {
                layer.data = arrival.data = std::move(*data);
                if (const std::string& damage = layer.data->info.damage; !damage.empty())
                    loaded.remarks.push_back(layer.path.filename().string() + ": " + damage + ".");
            } else {
                loaded.unread.push_back({layer.path, data.error()});
            }
        }
        arrived(arrival);
    }
    return {};
}

Result<Loaded> readFiles(Loaded request, const ShowProgress& show, const JobControl& control) {
    if (lookAt(request.scene, request.layers, control)) {
        Loaded shown;
        shown.scene = request.scene;
        const auto first = std::stable_partition(request.layers.begin(), request.layers.end(),
                                                 [](const Layer& layer) { return !layer.data; });
        std::move(first, request.layers.end(), std::back_inserter(shown.layers));
        request.layers.erase(first, request.layers.end());
        nameLayers(shown.layers, request.scene);
        const auto remarks = recogniseUnits(shown.layers, request.scene);
        show({shown.layers, remarks, {}});
        request.scene.layers.insert(request.scene.layers.end(), shown.layers.begin(), shown.layers.end());
        if (request.scene.target.empty()) request.scene.target = shown.layers.front().id;
        const Status read = readAll(
            shown,
            [&](const Arrival& arrival) {
                show({{}, {}, {arrival}});
            },
            control.sub(0, 0.9));
        if (!read) return fail(read.error());
        request.tooLarge = std::move(shown.tooLarge);
        request.unread = std::move(shown.unread);
        request.remarks = std::move(shown.remarks);
    }
    const Status read = readAll(
        request, [](const Arrival&) {}, control);
    if (!read) return fail(read.error());
    std::erase_if(request.layers, [](const Layer& layer) { return !layer.data; });
    nameLayers(request.layers, request.scene);
    for (const std::string& sentence : recogniseUnits(request.layers, request.scene))
        request.remarks.push_back(sentence);
    return request;
}

Result<Loaded> readCaseLayers(Loaded request, const ShowProgress& show, const JobControl& control) {
    const bool early = lookAt(request.scene, request.layers, control);
    if (early) show({request.layers, {}, {}});
    const Status read = readAll(
        request,
        [&](const Arrival& arrival) {
            if (early) show({{}, {}, {arrival}});
        },
        control);
    if (!read) return fail(read.error());
    return request;
}

}  // namespace vestige
