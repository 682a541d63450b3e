#include "ui/document/Loader.h"

#include <algorithm>
#include <cmath>

#include "core/scene/Edits.h"
#include "core/scene/FileEvidence.h"
#include "core/scene/SameData.h"
#include "ui/document/Autosave.h"
#include "ui/document/Document.h"
#include "ui/document/LayerDefaults.h"
#include "ui/document/LoadJob.h"
#include "ui/document/Notices.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

/// Kept round what the other layers cover.
constexpr double kBoxMargin = 0.1;

Status firstOf(const std::vector<Error>& problems) {
    if (problems.empty()) return {};
    return fail(problems.front());
}

/// The part of the file that the layers on show cover, in the file's unit; nothing when they lie elsewhere or
/// cover all of it.
std::optional<BoundingBox> coveredByOthers(const SceneState& scene, const TooLarge& large) {
    BoundingBox others;
    for (const Layer& layer : scene.layers)
        if (layer.data && layer.visible && layer.id != large.layer.id && !layer.data->isPreview())
            others.add(layer.data->points->bounds().transformed(sceneFromLayer(layer)));
    const BoundingBox& whole = large.check.peeked.bounds;
    if (others.empty() || whole.empty()) return std::nullopt;
    const double metres = large.layer.metresPerUnit();
    BoundingBox box;
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(std::max(1.0, kBoxMargin * others.diagonal()));
    // Heights are all kept: those of the layers say nothing about the file's.
    box.min = ((others.min - margin) / metres).cwiseMax(whole.min);
    box.max = ((others.max + margin) / metres).cwiseMin(whole.max);
    box.min.z() = whole.min.z();
    box.max.z() = whole.max.z();
    if (box.empty()) return std::nullopt;
    const bool smaller = (box.extent().head<2>().array() < 0.9 * whole.extent().head<2>().array()).any();
    return smaller ? std::optional(box) : std::nullopt;
}

}  // namespace

Loader::Loader(Document& document, JobRunner& jobs, Notices& notices, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), notices_(notices) {
    connect(&document_, &Document::replaced, this, [this] {
        ++replacements_;
        previews_.clear();
        unplaced_.clear();
        notices_.withdrawOffers();
    });
    connect(&document_, &Document::changed, this, [this] { place(); });
}

std::optional<CaseOpener> Loader::opener() const {
    return autosave_ ? std::optional(autosave_->opener()) : std::nullopt;
}

Status Loader::openCase(const std::filesystem::path& file) {
    return load(tr("Opening %1").arg(toQt(file.filename())),
                [opener = opener(), file] { return vestige::openCase(opener, file); });
}

void Loader::recover(const Abandoned& abandoned, std::function<void(bool)> done) {
    static_cast<void>(load(
        tr("Recovering a case"), [opener = opener(), abandoned] { return openAbandoned(opener, abandoned); },
        std::move(done)));
}

void Loader::findAbandoned(std::function<void(std::vector<Abandoned>)> found) {
    if (!autosave_) return;
    using All = std::vector<Abandoned>;
    jobs_.run<All>(
        tr("Looking for changes that were not saved"),
        [opener = autosave_->opener()](const JobControl&) -> Result<All> { return opener.abandoned(); },
        [found = std::move(found)](Result<All> all) {
            if (all) found(std::move(*all));
        });
}

Status Loader::load(const QString& title, std::function<Result<OpenedCase>()> open,
                    std::function<void(bool)> ended) {
    problems_.clear();
    const auto shown = std::make_shared<int>(-1);  // the document's number once the case is in it
    const auto replace = [this, shown, asked = replacements_, step = document_.step()](
                             const OpenedCase& opened, const std::vector<Layer>& read) {
        // The user has agreed to leave the case as it was then.
        const bool edited = document_.step() != (asked == replacements_ ? step : 0);
        put(opened, read, edited);
        *shown = replacements_;
    };
    jobs_.runInParts<Loaded, Progress>(
        title,
        [open = std::move(open)](const JobControl& control, const ShowProgress& show) -> Result<Loaded> {
            auto opened = open();
            if (!opened) return fail(opened.error());
            if (control.cancelled()) return fail(cancelledError());
            return readCaseLayers(layersToRead(std::move(*opened)), show, control);
        },
        [this, replace, shown](Progress progress) {
            if (*shown < 0) {
                replace(*progress.opened, progress.layers);
                for (const Layer& layer : progress.layers)
                    if (layer.data) previews_.push_back(layer.data);
            }
            if (*shown == replacements_) take(progress.arrivals);
        },
        [this, replace, shown, ended = std::move(ended)](Result<Loaded> loaded) {
            if (*shown >= 0 && *shown != replacements_) return;
            dropPreviews();
            if (!loaded && *shown < 0) {
                tell(loaded.error());
                if (ended) ended(false);
                return;
            }
            if (*shown < 0) replace(*loaded->opened, loaded->layers);
            if (loaded) {
                remark(loaded->remarks);
                tell(*loaded, false);
                if (loaded->opened->unreadable) tellUnreadable(*loaded->opened->unreadable);
            } else {
                tellDifferences();
                tellStopped(loaded.error());
            }
            if (const auto& file = document_.state().file; !file.empty()) emit this->opened(toQt(file));
            if (ended) ended(true);
        });
    return firstOf(problems_);
}

void Loader::tellUnreadable(Error error) {
    if (!error.hint.empty()) error.hint += "; ";
    error.hint += "its changes are recovered as a case without a place";
    notices_.failed(error);
}

/// Puts the case in the document's place with the data that were read, and what was not saved on top of it.
void Loader::put(const OpenedCase& opened, const std::vector<Layer>& read, bool edited) {
    const std::shared_ptr<CaseSession>& session = opened.session;
    SceneState saved = opened.saved;
    std::optional<Recovered> unsaved = opened.unsaved;
    const QString name = saved.file.empty() ? tr("another") : toQt(saved.file.filename());
    const bool again = autosave_ && session && autosave_->isOpen(session);
    if (edited && again) unsaved = Recovered{document_.state(), {}};
    const auto giveData = [&](SceneState& scene) {
        for (Layer& layer : scene.layers) {
            for (const Layer& other : read)
                if (!layer.data && readsTheSame(other, layer)) layer.data = other.data;
            noteEvidence(layer);
        }
    };
    giveData(saved);
    if (unsaved) giveData(unsaved->state);
    if (autosave_ && session) autosave_->follow(session, edited && !again);
    document_.replace(std::move(saved));
    const bool restored =
        unsaved && document_.perform(restoreState(std::move(unsaved->state), "recover unsaved changes"));
    if (restored && !unsaved->sentence.empty()) emit recovered(said(unsaved->sentence));
    if (edited && autosave_)
        notices_.warn(again
                          ? tr("%1 was changed while it was opened again. These changes are in place, as one "
                               "step that Undo takes back.")
                                .arg(name)
                          : tr("The case before was changed while %1 was read. These changes are kept and "
                               "offered the next time.")
                                .arg(name));
}

/// Of files that are not what became part of the case.
void Loader::tellDifferences() {
    for (const Layer& layer : document_.state().layers)
        if (const auto difference = evidenceDifference(layer))
            notices_.failed({ErrorCode::input, *difference, {}, {}});
}

Status Loader::addFiles(const std::vector<std::filesystem::path>& files, bool salvage) {
    if (files.empty()) return {};
    std::vector<Layer> layers;
    for (const auto& file : files) {
        Layer layer;
        layer.path = std::filesystem::absolute(file).lexically_normal();
        layer.salvage = salvage;
        layers.push_back(std::move(layer));
    }
    add(std::move(layers));
    return firstOf(problems_);
}

void Loader::add(std::vector<Layer> layers) {
    problems_.clear();
    const QString what =
        layers.size() == 1 ? toQt(layers.front().path.filename()) : tr("%1 files").arg(layers.size());
    Loaded request;
    request.scene = document_.state();
    request.layers = std::move(layers);
    const auto step = std::make_shared<std::uint64_t>(0);  // that added previews
    jobs_.runInParts<Loaded, Progress>(
        tr("Reading %1").arg(what),
        [request](const JobControl& control, const ShowProgress& show) {
            return readFiles(request, show, control);
        },
        [this, before = replacements_, step](Progress progress) {
            if (before != replacements_) return;
            enter(progress.layers);
            remark(progress.remarks);
            for (const Layer& layer : progress.layers) previews_.push_back(layer.data);
            if (!progress.layers.empty()) *step = document_.step();
            for (const Layer& layer : progress.layers) emit opened(toQt(layer.path));
            take(progress.arrivals);
        },
        [this, before = replacements_, step](Result<Loaded> loaded) {
            if (before != replacements_) return;
            dropPreviews();
            if (!loaded) {
                // Where adding them was the last step they are taken back; else they stay without data.
                const bool last = *step != 0 && document_.step() == *step;
                if (last) document_.undo();
                return *step == 0 || last ? tell(loaded.error()) : tellStopped(loaded.error());
            }
            enter(loaded->layers);
            remark(loaded->remarks);
            tell(*loaded, true);
            for (const Layer& layer : loaded->layers) emit opened(toQt(layer.path));
        });
}

/// A layer of the case, after it was changed to load a part of its file.
void Loader::readAgain(const Layer& layer) {
    problems_.clear();
    Loaded request;
    request.scene = document_.state();
    request.layers = {layer};
    jobs_.run<Loaded>(
        tr("Reading %1").arg(toQt(layer.path.filename())),
        [request](const JobControl& control) -> Result<Loaded> {
            Loaded loaded = request;
            const Status read = readAll(
                loaded, [](const Arrival&) {}, control);
            if (!read) return fail(read.error());
            return loaded;
        },
        [this, before = replacements_](Result<Loaded> loaded) {
            if (before != replacements_) return;
            if (!loaded) return tell(loaded.error());
            for (const Layer& read : loaded->layers)
                if (read.data) unplaced_.push_back(read);
            place();
            tell(*loaded, false);
        });
}

void Loader::enter(const std::vector<Layer>& layers) {
    if (layers.empty()) return;
    QStringList names;
    for (const Layer& layer : layers) names << QString::fromStdString(layer.name);
    document_.begin("add " + names.join(", "));
    for (Layer layer : layers) {
        noteEvidence(layer);
        document_.perform(addLayer(std::move(layer)));
    }
    if (document_.state().target.empty()) document_.perform(setTarget(layers.front().id));
    document_.end();
}

void Loader::take(const std::vector<Arrival>& arrivals) {
    for (const Arrival& arrival : arrivals) {
        std::erase(previews_, arrival.before);
        if (arrival.before) {
            document_.replaceData(arrival.before, arrival.data);
        } else if (arrival.data) {
            unplaced_.push_back(arrival.layer);
            unplaced_.back().data = arrival.data;
        }
    }
    place();
}

/// Layers may have changed since their files were asked for: what was read goes to those that still ask for
/// it, at the latest when undo or redo brings one back.
void Loader::place() {
    std::vector<std::pair<std::string, std::shared_ptr<const LayerData>>> found;
    std::erase_if(unplaced_, [&](const Layer& read) {
        const std::size_t before = found.size();
        for (const Layer& layer : document_.state().layers)
            if (!layer.data && readsTheSame(layer, read)) found.emplace_back(layer.id, read.data);
        return found.size() > before;
    });
    for (const auto& [layer, data] : found) document_.attachData(layer, data);
}

/// No more comes for the previews that are left.
void Loader::dropPreviews() {
    for (const auto& preview : std::exchange(previews_, {})) document_.replaceData(preview, nullptr);
}

void Loader::remark(const std::vector<std::string>& remarks) {
    QStringList sentences;
    for (const std::string& sentence : remarks) sentences << said(sentence);
    if (!sentences.isEmpty()) notices_.inform(sentences.join("\n"));
}

void Loader::tell(const Error& error) {
    problems_ = {error};
    notices_.failed(error);
}

/// After the layers came into the document.
void Loader::tellStopped(const Error& error) {
    if (error.code != ErrorCode::cancelled) return tell(error);
    problems_ = {error};
    const auto& layers = document_.state().layers;
    const auto unread = std::count_if(layers.begin(), layers.end(), [](const Layer& l) { return !l.data; });
    notices_.inform(unread == 0   ? tr("Cancelled; every layer was read.")
                    : unread == 1 ? tr("Cancelled; 1 layer was not read.")
                                  : tr("Cancelled; %1 layers were not read.").arg(unread));
}

void Loader::tell(const Loaded& loaded, bool added) {
    problems_.clear();
    QStringList sentences;
    std::vector<Notices::Offer> offers;
    if (!added)
        for (const Layer& layer : document_.state().layers)
            if (const auto difference = evidenceDifference(layer)) sentences << saidSentence(*difference);
    for (const auto& [file, problem] : loaded.unread) {
        problems_.push_back(problem);
        sentences << saidSentence(problem);
        if (!problem.salvageable) continue;
        const QString text = loaded.unread.size() == 1
                                 ? tr("Load what is whole")
                                 : tr("Load what is whole of %1").arg(toQt(file.filename()));
        offers.push_back({text,
                          [this, file = file, added, asked = replacements_] {
                              if (asked != replacements_) return;
                              const auto& layers = document_.state().layers;
                              const bool there = std::any_of(
                                  layers.begin(), layers.end(),
                                  [&](const Layer& layer) { return layer.path == file && !layer.data; });
                              if (added && !there)
                                  static_cast<void>(addFiles({file}, true));
                              else
                                  salvage(file);
                          },
                          toQt(file)});
    }
    for (const TooLarge& large : loaded.tooLarge) {
        problems_.push_back(tooLarge(large.layer.path, large.check.estimate, {}));
        sentences << sentenceOn(large);
        addOffers(large, loaded.tooLarge.size() + loaded.unread.size() > 1, offers);
    }
    // One notice for all: another would take the place of the first.
    if (!offers.empty())
        notices_.offer(sentences.join("\n"), offers);
    else if (!sentences.isEmpty())
        notices_.warn(sentences.join("\n"));
}

void Loader::salvage(const std::filesystem::path& file) {
    const std::vector<Layer> layers = document_.state().layers;
    for (const Layer& layer : layers) {
        if (layer.path != file || layer.data || layer.salvage) continue;
        Layer changed = layer;
        changed.salvage = true;
        document_.perform(changeLayer(changed, "load what is whole of " + changed.name));
        readAgain(changed);
    }
}

QString Loader::sentenceOn(const TooLarge& large) {
    if (!large.check.estimate.partsHelp)
        return saidSentence(
            tooLarge(large.layer.path, large.check.estimate, commandLineOffer(large.check.estimate)));
    return tr("%1: %2. It was not read.")
        .arg(toQt(large.layer.path.filename()), said(large.check.estimate.sentence()));
}

void Loader::addOffers(const TooLarge& large, bool oneOfMany, std::vector<Notices::Offer>& offers) {
    if (!large.check.estimate.partsHelp) return;
    // An added file has no layer yet, or one that shows nothing; a layer of the case remembers the part.
    const auto load = [this, asked = replacements_](Layer part) {
        if (asked != replacements_) return;
        const Layer* held = document_.state().layer(part.id);
        if (!held) return add({std::move(part)});
        if (held->path != part.path) return;
        Layer changed = *held;
        changed.keepEvery = part.keepEvery;
        changed.box = part.box;
        changed.data = nullptr;
        document_.perform(changeLayer(changed, "load a part of " + changed.name));
        readAgain(changed);
    };
    const QString of = oneOfMany ? tr(" of %1").arg(toQt(large.layer.path.filename())) : QString();
    const QString group = toQt(large.layer.path);
    const std::uint32_t every = large.check.estimate.keepEveryToFit;
    Layer thinned = large.layer;
    thinned.keepEvery = every;
    thinned.data = nullptr;
    offers.push_back(
        {tr("Load every %1 point").arg(ordinalText(every)) + of, [load, thinned] { load(thinned); }, group});
    if (const auto box = coveredByOthers(document_.state(), large)) {
        Layer part = large.layer;
        part.box = box;
        part.data = nullptr;
        offers.push_back(
            {tr("Load only where the other layers are") + of, [load, part] { load(part); }, group});
    }
}

}  // namespace vestige
