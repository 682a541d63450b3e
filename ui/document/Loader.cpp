#include "ui/document/Loader.h"

#include "core/pipeline/LoadLayers.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
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
    std::vector<std::filesystem::path> unread;  ///< the files of the problems
    std::vector<std::string> remarks;
};

/// Reads each file of `loaded.layers`; what fails stays without data.
Result<Loaded> readLayers(Loaded loaded, const JobControl& control) {
    const double count = static_cast<double>(loaded.layers.size());
    for (std::size_t i = 0; i < loaded.layers.size(); ++i) {
        Layer& layer = loaded.layers[i];
        const auto step = control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        step.progress(0, "Reading " + layer.path.filename().string());
        auto data = loadLayerData(loaded.scene.resolve(layer.path), step, layer.salvage);
        if (!data && data.error().code == ErrorCode::cancelled) return fail(data.error());
        if (!data) {
            loaded.problems.push_back(data.error());
            loaded.unread.push_back(layer.path);
            continue;
        }
        layer.data = std::move(*data);
        if (const std::string& damage = layer.data->info.damage; !damage.empty())
            loaded.remarks.push_back(layer.path.filename().string() + ": " + damage + ".");
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
    std::vector<std::string> remarks;
    auto scene = readCase(file, &remarks);
    if (!scene) return fail(scene.error());
    problems_.clear();
    tintApart(scene->layers);
    auto layers = scene->layers;
    jobs_.run<Loaded>(
        tr("Opening %1").arg(toQt(file.filename())),
        [loaded = Loaded{std::move(*scene), std::move(layers), {}, {}, std::move(remarks)}](
            const JobControl& control) { return readLayers(loaded, control); },
        [this, file](Result<Loaded> loaded) {
            if (!loaded) return tell({loaded.error()});
            loaded->scene.layers = std::move(loaded->layers);
            loaded->scene.file = file;
            document_.replace(std::move(loaded->scene));
            remark(loaded->remarks);
            tell(loaded->problems);
            emit opened(toQt(file));
        });
    return firstOf(problems_);
}

Status Loader::addFiles(const std::vector<std::filesystem::path>& files, bool salvage) {
    if (files.empty()) return {};
    problems_.clear();
    Loaded request;
    request.scene = document_.state();
    for (const auto& file : files) {
        Layer layer;
        layer.path = std::filesystem::absolute(file).lexically_normal();
        layer.salvage = salvage;
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
            for (const std::string& sentence : recogniseUnits(loaded->layers, loaded->scene))
                loaded->remarks.push_back(sentence);
            return loaded;
        },
        [this](Result<Loaded> loaded) {
            if (!loaded) return tell({loaded.error()});
            enter(loaded->layers);
            remark(loaded->remarks);
            tellOfFiles(loaded->problems, loaded->unread);
            for (const Layer& layer : loaded->layers) emit opened(toQt(layer.path));
        });
    return firstOf(problems_);
}

void Loader::enter(const std::vector<Layer>& layers) {
    if (layers.empty()) return;
    QStringList names;
    for (const Layer& layer : layers) names << QString::fromStdString(layer.name);
    document_.begin(tr("add %1").arg(names.join(", ")));
    for (const Layer& layer : layers) document_.perform(addLayer(layer));
    if (document_.state().target.empty()) document_.perform(setTarget(layers.front().id));
    document_.end();
}

void Loader::remark(const std::vector<std::string>& remarks) {
    QStringList sentences;
    for (const std::string& sentence : remarks) sentences << QString::fromStdString(sentence);
    if (!sentences.isEmpty()) notices_.inform(sentences.join("\n"));
}

void Loader::tellOfFiles(const std::vector<Error>& problems,
                         const std::vector<std::filesystem::path>& files) {
    problems_ = problems;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        if (!problems[i].salvageable) {
            notices_.failed(problems[i]);
            continue;
        }
        notices_.offer(problems[i], tr("Load what is whole"),
                       [this, file = files[i]] { static_cast<void>(addFiles({file}, true)); });
    }
}

void Loader::tell(const std::vector<Error>& problems) {
    problems_ = problems;
    for (const Error& problem : problems) notices_.failed(problem);
}

}  // namespace vestige
