#include "ui/document/Comparison.h"

#include <algorithm>
#include <iterator>

namespace vestige {
namespace {

/// The next of the ascending choices in that direction.
template <std::size_t N>
int nextOf(const int (&choices)[N], int now, int direction) {
    const auto at = std::lower_bound(std::begin(choices), std::end(choices), now) - std::begin(choices);
    return choices[std::clamp<std::ptrdiff_t>(at + direction, 0, static_cast<std::ptrdiff_t>(N) - 1)];
}

}  // namespace

Comparison::Comparison(QObject* parent) : QObject(parent) {
    connect(&timer_, &QTimer::timeout, this, [this] {
        otherShown_ = !otherShown_;
        emit adjusted();
    });
}

ViewComparison Comparison::shown() const {
    const bool poses = what_ == What::beforeAfter;
    return {mode_.value_or(CompareMode::swipe),
            divider_,
            tile_px_,
            otherShown_,
            (poses ? tr("After") : tr("Source")).toStdString(),
            (poses ? tr("Before") : tr("Target")).toStdString()};
}

void Comparison::setMode(std::optional<CompareMode> mode) {
    if (mode == mode_) return;
    const bool same = mode && mode_;
    mode_ = mode;
    otherShown_ = held_ = false;
    runTimer();
    if (!same) return emit switched();
    emit adjusted();
}

void Comparison::setWhat(What what) {
    if (what == what_) return;
    what_ = what;
    emit switched();
}

void Comparison::setDivider(double share) {
    divider_ = std::clamp(share, 0.02, 0.98);
    emit adjusted();
}

void Comparison::setTile(int pixels) {
    tile_px_ = std::clamp(pixels, std::begin(kTiles)[0], std::end(kTiles)[-1]);
    emit adjusted();
}

void Comparison::setBlink(int milliseconds) {
    blink_ms_ = std::clamp(milliseconds, std::begin(kBlinks_ms)[0], std::end(kBlinks_ms)[-1]);
    runTimer();
    emit adjusted();
}

void Comparison::toggleHeld() {
    if (mode_ != CompareMode::blink) return;
    held_ = !held_;
    if (held_) otherShown_ = !otherShown_;
    runTimer();
    emit adjusted();
}

void Comparison::step(int direction) {
    if (mode_ == CompareMode::swipe) setDivider(divider_ + 0.02 * direction);
    if (mode_ == CompareMode::checkerboard) setTile(nextOf(kTiles, tile_px_, direction));
    if (mode_ == CompareMode::blink) setBlink(nextOf(kBlinks_ms, blink_ms_, direction));
}

void Comparison::runTimer() {
    if (mode_ == CompareMode::blink && !held_)
        timer_.start(blink_ms_);
    else
        timer_.stop();
}

}  // namespace vestige
