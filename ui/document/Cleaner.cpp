#include "ui/document/Cleaner.h"

#include <vector>

#include "core/scene/CleanedData.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {

Cleaner::Cleaner(Document& document, JobRunner& jobs, Notices& notices, QObject* parent)
    : QObject(parent), document_(document), jobs_(jobs), notices_(notices) {
    connect(&document_, &Document::replaced, this, [this] {
        settled_.clear();
        asked_.clear();
    });
    connect(&document_, &Document::changed, this, [this] { follow(); });
}

/// What it attaches is a change, too, and an inline runner is done before run() returns.
void Cleaner::follow() {
    again_ = true;
    if (following_) return;
    following_ = true;
    while (again_) {
        again_ = false;
        std::vector<std::string> ids;
        for (const Layer& layer : document_.state().layers) ids.push_back(layer.id);
        for (const std::string& id : ids)
            if (const Layer* layer = document_.state().layer(id)) followOne(*layer);
    }
    following_ = false;
}

void Cleaner::followOne(const Layer& layer) {
    const auto loaded = loadedData(layer);
    if (!loaded) return;
    Pair& settled = settled_[layer.id];
    if (settled.is(layer)) return;
    if (isCleaned(*layer.data, layer.cleaning.get())) {
        settled = {layer.data, layer.cleaning};
        return;
    }
    const auto mismatch = cleaningMismatch(layer);
    if (!layer.cleaning || mismatch) {
        settled = {loaded, layer.cleaning};
        if (mismatch)
            notices_.warn(QString::fromStdString(*mismatch) +
                          tr(". They were not taken out; Bring back forgets the cleaning."));
        if (layer.data != loaded) document_.attachData(layer.id, loaded);
        return;
    }
    const std::size_t left = loaded->points->size() - layer.cleaning->removed.size();
    if (layer.data->points->size() < left) {
        document_.attachData(layer.id, loaded);
        return;  // and once more
    }
    const Pair& asked = asked_[layer.id];
    if (asked.cleaning != layer.cleaning || asked.data.lock() != loaded) start(layer, loaded);
}

void Cleaner::start(const Layer& layer, const std::shared_ptr<const LayerData>& loaded) {
    using Data = std::shared_ptr<const LayerData>;
    asked_[layer.id] = {loaded, layer.cleaning};
    jobs_.run<Data>(
        tr("Taking points out of %1").arg(QString::fromStdString(layer.name)),
        [loaded, cleaning = layer.cleaning](const JobControl& control) {
            return cleanedData(loaded, *cleaning, control);
        },
        [this, id = layer.id, loaded, cleaning = layer.cleaning](Result<Data> cleaned) {
            Pair& asked = asked_[id];
            if (asked.cleaning == cleaning && asked.data.lock() == loaded) asked = {};
            const Layer* now = document_.state().layer(id);
            if (!now || now->cleaning != cleaning || loadedData(*now) != loaded) return;
            if (cleaned) return document_.attachData(id, *cleaned);
            // They stay hidden; whatever computes with the layer takes them out first.
            settled_[id] = {now->data, cleaning};
            if (cleaned.error().code != ErrorCode::cancelled) notices_.failed(cleaned.error());
        });
}

}  // namespace vestige
