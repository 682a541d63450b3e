#include "ui/document/Loader.h"

#include <algorithm>

#include "core/pipeline/LoadLayers.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "ui/document/Autosave.h"
#include "ui/document/Document.h"
#include "ui/document/LayerDefaults.h"
#include "ui/document/Notices.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

struct Loaded {
    SceneState scene;
    std::vector<Layer> layers;
    std::vector<Error> problems;
    std::vector<std::string> remarks;
};

/// Reads each file of `loaded.layers`; what fails stays without data.
Result<Loaded> readLayers(Loaded loaded, const JobControl& control) {
    const double count = static_cast<double>(loaded.layers.size());
    for (std::size_t i = 0; i < loaded.layers.size(); ++i) {
        Layer& layer = loaded.layers[i];
        const auto step = control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        step.progress(0, "Reading " + layer.path.filename().string());
        auto data = loadLayerData(loaded.scene.resolve(layer.path), step);
        if (!data && data.error().code == ErrorCode::cancelled) return fail(data.error());
        if (data)
            layer.data = std::move(*data);
        else
            loaded.problems.push_back(data.error());
    }
    return loaded;
}

Status firstOf(const std::vector<Error>& problems) {
    if (problems.empty()) return {};
    return fail(problems.front());
}

}  // namespace

Loader::Loader(Document& document, JobRunner& jobs, Notices& notices, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), notices_(notices) {}

Status Loader::openCase(const std::filesystem::path& file) {
    std::shared_ptr<CaseSession> session = autosave_ ? autosave_->open(file) : nullptr;
    std::vector<std::string> remarks;
    auto scene = readCase(file, &remarks, session ? UnsavedEdits::passedOver : UnsavedEdits::told);
    if (!scene) return fail(scene.error());
    scene->file = file;
    return load(std::move(session), std::move(*scene), remarks);
}

Status Loader::recover(const Abandoned& abandoned) {
    const std::filesystem::path file = abandoned.content.caseFile;
    std::error_code unknown;
    if (!file.empty() && std::filesystem::exists(file, unknown)) return openCase(file);
    if (!autosave_) return {};
    return load(autosave_->takeOver(abandoned), SceneState(), {});
}

Status Loader::load(std::shared_ptr<CaseSession> session, SceneState saved,
                    const std::vector<std::string>& remarks) {
    problems_.clear();
    tintApart(saved.layers);
    std::optional<Recovered> unsaved;
    if (session) unsaved = session->takeRecovered();
    Loaded request;
    request.remarks = remarks;
    request.layers = saved.layers;
    // Undoing the recovery leads back to the saved case, so both need their files.
    if (unsaved)
        for (const Layer& layer : unsaved->state.layers)
            if (std::none_of(request.layers.begin(), request.layers.end(),
                             [&](const Layer& other) { return other.path == layer.path; }))
                request.layers.push_back(layer);
    const QString title =
        saved.file.empty() ? tr("Recovering a case") : tr("Opening %1").arg(toQt(saved.file.filename()));
    const std::filesystem::path file = saved.file;
    request.scene = std::move(saved);
    jobs_.run<Loaded>(
        title, [request](const JobControl& control) { return readLayers(request, control); },
        [this, file, session, unsaved](Result<Loaded> loaded) {
            if (!loaded) return tell({loaded.error()});
            const auto giveData = [&](SceneState& scene) {
                for (Layer& layer : scene.layers) {
                    for (const Layer& read : loaded->layers)
                        if (read.path == layer.path) layer.data = read.data;
                    noteEvidence(layer);
                }
            };
            giveData(loaded->scene);
            std::optional<Recovered> edits = unsaved;
            if (edits) giveData(edits->state);
            if (autosave_ && session) autosave_->follow(session);
            document_.replace(std::move(loaded->scene));
            if (edits && document_.perform(restoreState(std::move(edits->state), "recover unsaved changes")))
                emit recovered(QString::fromStdString(edits->sentence));
            remark(loaded->remarks);
            for (const Layer& layer : document_.state().layers)
                if (const auto difference = evidenceDifference(layer))
                    notices_.failed({ErrorCode::input, *difference, {}, {}});
            tell(loaded->problems);
            if (!file.empty()) emit opened(toQt(file));
        });
    return firstOf(problems_);
}

Status Loader::addFiles(const std::vector<std::filesystem::path>& files) {
    if (files.empty()) return {};
    problems_.clear();
    Loaded request;
    request.scene = document_.state();
    for (const auto& file : files) {
        Layer layer;
        layer.path = std::filesystem::absolute(file).lexically_normal();
        request.layers.push_back(std::move(layer));
    }
    const QString what =
        files.size() == 1 ? toQt(files.front().filename()) : tr("%1 files").arg(files.size());
    jobs_.run<Loaded>(
        tr("Reading %1").arg(what),
        [request](const JobControl& control) -> Result<Loaded> {
            auto loaded = readLayers(request, control);
            if (!loaded) return loaded;
            std::erase_if(loaded->layers, [](const Layer& layer) { return !layer.data; });
            nameLayers(loaded->layers, loaded->scene);
            loaded->remarks = recogniseUnits(loaded->layers, loaded->scene);
            return loaded;
        },
        [this](Result<Loaded> loaded) {
            if (!loaded) return tell({loaded.error()});
            enter(loaded->layers);
            remark(loaded->remarks);
            tell(loaded->problems);
            for (const Layer& layer : loaded->layers) emit opened(toQt(layer.path));
        });
    return firstOf(problems_);
}

void Loader::enter(const std::vector<Layer>& layers) {
    if (layers.empty()) return;
    QStringList names;
    for (const Layer& layer : layers) names << QString::fromStdString(layer.name);
    document_.begin(tr("add %1").arg(names.join(", ")));
    for (Layer layer : layers) {
        noteEvidence(layer);
        document_.perform(addLayer(std::move(layer)));
    }
    if (document_.state().target.empty()) document_.perform(setTarget(layers.front().id));
    document_.end();
}

void Loader::remark(const std::vector<std::string>& remarks) {
    QStringList sentences;
    for (const std::string& sentence : remarks) sentences << QString::fromStdString(sentence);
    if (!sentences.isEmpty()) notices_.inform(sentences.join("\n"));
}

void Loader::tell(const std::vector<Error>& problems) {
    problems_ = problems;
    for (const Error& problem : problems) notices_.failed(problem);
}

}  // namespace vestige
