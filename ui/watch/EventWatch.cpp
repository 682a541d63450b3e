#include "ui/watch/EventWatch.h"

#include <time.h>

#include <QAbstractEventDispatcher>
#include <QEvent>
#include <QMetaEnum>
#include <QThread>
#include <algorithm>
#include <chrono>

namespace vestige {
namespace {

constexpr std::int64_t kNamed_ns = 1000000;  // shorter stretches get no text
constexpr std::int64_t kKept_ns = 5000000;

QString millisecondsText(double seconds) {
    return QString::number(1e3 * seconds, 'f', 0);
}

}  // namespace

thread_local EventWatch* WatchedTime::current_ = nullptr;

void WatchedTime::begin(Kind kind, const char* what, const QString& detail) {
    watch_ = current_;
    kind_ = kind;
    what_ = what;
    detail_ = detail;
    watch_->began(*this);
}

void WatchedTime::end() {
    // The watch may have ended within this stretch.
    if (watch_ == current_) watch_->ended(*this);
}

QString WatchedTime::label() const {
    QString text = QString::fromLatin1(what_);
    if (kind_ == Kind::event) {
        const char* type = QMetaEnum::fromType<QEvent::Type>().valueToKey(type_);
        text += ' ' + (type ? QString::fromLatin1(type) : QString::number(type_));
    }
    return detail_.isEmpty() ? text : text + " '" + detail_ + '\'';
}

void WatchedEvent::beginEvent(const QObject& receiver, const QEvent& event) {
    type_ = event.type();
    begin(Kind::event, receiver.metaObject()->className(), receiver.objectName());
}

EventWatch::EventWatch(QObject* parent) : QObject(parent) {
    WatchedTime::current_ = this;
    auto* loop = QAbstractEventDispatcher::instance();
    connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, [this] {
        waiting_ns_ = now_ns();
        heldSince_ns_ = 0;
    });
    connect(loop, &QAbstractEventDispatcher::awake, this, [this] {
        // Told of each turn of the loop, also of those that did not wait.
        if (waiting_ns_ != 0) apart_ns_ += now_ns() - waiting_ns_;
        waiting_ns_ = 0;
    });
}

EventWatch::~EventWatch() {
    WatchedTime::current_ = nullptr;
}

std::int64_t EventWatch::now_ns() {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

std::int64_t EventWatch::work_ns() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return std::int64_t{1000000000} * used.tv_sec + used.tv_nsec;
}

void EventWatch::began(WatchedTime& stretch) {
    stretch.outer_ = innermost_;
    innermost_ = &stretch;
    stretch.loop_ = QThread::currentThread()->loopLevel();
    stretch.first_ = stretch.kind_ == WatchedTime::Kind::event &&
                     (!stretch.outer_ || stretch.loop_ > stretch.outer_->loop_);
    stretch.apart_ns_ = apart_ns_;
    stretch.apartWork_ns_ = apartWork_ns_;
    stretch.beganWork_ns_ = work_ns();
    stretch.began_ns_ = now_ns();
    if (stretch.first_) heldSince_ns_ = stretch.began_ns_;
}

void EventWatch::ended(const WatchedTime& stretch) {
    innermost_ = stretch.outer_;
    const std::int64_t own = now_ns() - stretch.began_ns_ - (apart_ns_ - stretch.apart_ns_);
    const std::int64_t work = work_ns() - stretch.beganWork_ns_ - (apartWork_ns_ - stretch.apartWork_ns_);
    if (stretch.kind_ == WatchedTime::Kind::drawing) {
        apart_ns_ += own;
        apartWork_ns_ += work;
        worstDrawing_ns_ = std::max(worstDrawing_ns_, own);
        return;
    }
    QString text;
    if (own > kNamed_ns) {
        text = stretch.label();
        // What took most of it says more than the event alone.
        if (2 * stretch.heaviest_ns_ > own) text += " > " + stretch.heaviest_;
    }
    if (!stretch.first_) {
        if (stretch.outer_ && own > stretch.outer_->heaviest_ns_) {
            stretch.outer_->heaviest_ns_ = own;
            stretch.outer_->heaviest_ = text;
        }
        return;
    }
    heldSince_ns_ = 0;
    if (stretch.outer_) {
        apart_ns_ += own;
        apartWork_ns_ += work;
    }
    ++events_;
    worst_ns_ = std::max(worst_ns_, own);
    worstWork_ns_ = std::max(worstWork_ns_, work);
    if (own < kKept_ns) return;
    Held& held = held_[text];
    held.what = text;
    held.worst_s = std::max(held.worst_s, 1e-9 * static_cast<double>(own));
    held.worstWork_s = std::max(held.worstWork_s, 1e-9 * static_cast<double>(work));
    held.total_s += 1e-9 * static_cast<double>(own);
    ++held.times;
}

std::vector<EventWatch::Held> EventWatch::held() const {
    std::vector<Held> all;
    for (const auto& [text, held] : held_) all.push_back(held);
    std::stable_sort(all.begin(), all.end(),
                     [](const Held& a, const Held& b) { return a.worst_s > b.worst_s; });
    return all;
}

void EventWatch::forget() {
    held_.clear();
    worst_ns_ = worstWork_ns_ = worstDrawing_ns_ = 0;
    events_ = 0;
}

QStringList EventWatch::report(std::size_t most) const {
    QStringList lines;
    lines << tr("The window was held for at most %1 ms by one of %2 events; longest drawing call %3 ms")
                 .arg(millisecondsText(worst_s()))
                 .arg(events_)
                 .arg(millisecondsText(worstDrawing_s()));
    const auto all = held();
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i)
        lines << tr("%1 ms (%2 times): %3")
                     .arg(millisecondsText(all[i].worst_s))
                     .arg(all[i].times)
                     .arg(all[i].what);
    return lines;
}

std::int64_t EventWatch::heldFor_ns() const {
    const std::int64_t since = heldSince_ns_;
    return since == 0 ? 0 : now_ns() - since;
}

}  // namespace vestige
