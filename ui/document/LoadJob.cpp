#include "ui/document/LoadJob.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/scene/CaseFile.h"
#include "core/scene/SameData.h"
#include "ui/document/LayerDefaults.h"

namespace vestige {

Result<OpenedCase> openCase(const std::optional<CaseOpener>& opener, const std::filesystem::path& file) {
    OpenedCase opened;
    if (opener) opened.session = opener->open(file);
    auto saved =
        readCase(file, &opened.remarks, opened.session ? UnsavedEdits::passedOver : UnsavedEdits::told);
    if (!saved) return fail(saved.error());
    opened.saved = std::move(*saved);
    opened.saved.file = file;
    if (opened.session) opened.unsaved = opened.session->takeRecovered();
    return opened;
}

Result<OpenedCase> openAbandoned(const std::optional<CaseOpener>& opener, const Abandoned& abandoned) {
    const std::filesystem::path file = abandoned.content.caseFile;
    std::error_code unknown;
    OpenedCase opened;
    if (!file.empty() && std::filesystem::exists(file, unknown)) {
        const auto saved = readCase(file, nullptr, UnsavedEdits::passedOver);
        if (saved) return openCase(opener, file);
        opened.unreadable = saved.error();
    }
    if (!opener) return fail(opened.unreadable.value_or(cancelledError()));
    auto session = opener->takeOver(abandoned);
    if (!session) return fail(session.error());
    opened.session = std::move(*session);
    opened.unsaved = opened.session->takeRecovered();
    return opened;
}

Loaded layersToRead(OpenedCase opened) {
    tintApart(opened.saved.layers);
    Loaded request;
    request.remarks = opened.remarks;
    request.layers = opened.saved.layers;
    request.scene = opened.saved;
    // Undoing the recovery leads back to the saved case, so both need their files.
    if (opened.unsaved)
        for (const Layer& layer : opened.unsaved->state.layers)
            if (std::none_of(request.layers.begin(), request.layers.end(),
                             [&](const Layer& other) { return readsTheSame(other, layer); }))
                request.layers.push_back(layer);
    request.opened = std::make_shared<const OpenedCase>(std::move(opened));
    return request;
}

bool lookAt(const SceneState& scene, std::vector<Layer>& layers, const JobControl& control) {
    bool any = false;
    for (Layer& layer : layers) {
        if (layer.data || control.cancelled()) continue;
        const auto file = scene.resolve(layer.path);
        const ReadOptions options = readOptionsOf(layer);
        // What goes wrong here goes wrong when the whole is read, and is told then.
        const auto check = checkLoad(file, options, LoadedFor::scene, control);
        if (!check || !check->estimate.fits()) continue;
        const auto preview = previewLayerData(file, *check, options, control);
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
        show({nullptr, shown.layers, remarks, {}});
        request.scene.layers.insert(request.scene.layers.end(), shown.layers.begin(), shown.layers.end());
        if (request.scene.target.empty()) request.scene.target = shown.layers.front().id;
        const Status read = readAll(
            shown,
            [&](const Arrival& arrival) {
                show({nullptr, {}, {}, {arrival}});
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
    if (early) show({request.opened, request.layers, {}, {}});
    const Status read = readAll(
        request,
        [&](const Arrival& arrival) {
            if (early) show({nullptr, {}, {}, {arrival}});
        },
        control);
    if (!read) return fail(read.error());
    return request;
}

}  // namespace vestige
