#include "ui/document/FitTrace.h"

#include <algorithm>
#include <mutex>

#include "core/base/Numbers.h"
#include "ui/document/Document.h"
#include "ui/document/Preview.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {
constexpr int kEvery_ms = 33;
}  // namespace

/// What came since it was emptied last. The worker holds the lock for the length of a push.
struct FitTrace::Mailbox {
    struct Letter {
        std::string layer;
        RegistrationStep step;
    };
    std::mutex mutex;
    std::vector<Letter> letters;

    void put(const std::string& layer, const RegistrationStep& step) {
        const std::lock_guard lock(mutex);
        letters.push_back({layer, step});
    }
    std::vector<Letter> empty() {
        const std::lock_guard lock(mutex);
        return std::exchange(letters, {});
    }
};

FitTrace::FitTrace(const Document& document, Preview& preview, QObject* parent)
    : QObject(parent), document_(document), preview_(preview) {
    timer_.setInterval(kEvery_ms);
    connect(&timer_, &QTimer::timeout, this, [this] { take(); });
    connect(&document_, &Document::replaced, this, [this] {
        steps_.clear();
        emit changed();
    });
    connect(&preview_, &Preview::changed, this, [this] {
        if (preview_.owner() == this || shownLayer_.empty()) return;
        shownLayer_.clear();
        emit changed();
    });
}

FitTrace::Watches FitTrace::begin() {
    mailbox_ = std::make_shared<Mailbox>();
    timer_.start();
    return [mailbox = mailbox_](const std::string& layer) -> RegistrationWatch {
        return [mailbox, layer](const RegistrationStep& step) { mailbox->put(layer, step); };
    };
}

void FitTrace::finish() {
    if (!mailbox_) return;
    take();
    mailbox_.reset();
    liveLayer_.clear();
    timer_.stop();
    preview_.end();
    emit changed();
}

void FitTrace::take() {
    const auto letters = mailbox_->empty();
    if (letters.empty()) return;
    for (const auto& letter : letters) {
        Steps& steps = steps_[letter.layer];
        // A registration begins with the start of its first level.
        if (letter.step.level == 0 && letter.step.iteration == 0) steps.clear();
        steps.push_back(letter.step);
    }
    liveLayer_ = letters.back().layer;
    const std::string layer = liveLayer_;
    showStep(layer, steps_[layer].size() - 1);
}

const FitTrace::Steps& FitTrace::steps(const std::string& layer) const {
    static const Steps none;
    const auto found = steps_.find(layer);
    return found == steps_.end() ? none : found->second;
}

std::optional<std::size_t> FitTrace::cursor(const std::string& layer) const {
    if (layer.empty() || layer != shownLayer_) return std::nullopt;
    return shownStep_;
}

void FitTrace::replay(const std::string& layer, std::size_t step) {
    if (!live() && step < steps(layer).size()) showStep(layer, step);
}

void FitTrace::showStep(const std::string& layer, std::size_t index) {
    const RegistrationStep& step = steps(layer)[index];
    shownLayer_ = layer;
    shownStep_ = index;
    preview_.show(this, layer, step.targetFromSource,
                  tr("%1: size %2 of %3, voxels %4 m, iteration %5")
                      .arg(live() ? tr("Registering") : tr("Replay"))
                      .arg(step.level + 1)
                      .arg(std::max<int>(static_cast<int>(step.levels),
                                         static_cast<int>(steps(layer).back().level) + 1))
                      .arg(toQt(fixedText(step.voxel_m, 2)))
                      .arg(step.iteration));
    emit changed();
}

}  // namespace vestige
