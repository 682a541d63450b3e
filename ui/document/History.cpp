#include "ui/document/History.h"

#include <algorithm>

#include "ui/document/Document.h"

namespace vestige {

History::History(Document& document, QObject* parent) : QObject(parent), document_(document) {
    connect(&document_, &Document::replaced, this, [this] { clear(); });
    connect(&document_, &Document::changed, this, [this] { follow(); });
}

void History::clear() {
    steps_.clear();
    done_ = 0;
}

void History::follow() {
    const std::uint64_t now = document_.step();
    const auto known =
        std::find_if(steps_.begin(), steps_.end(), [now](const Step& step) { return step.number == now; });
    if (now == 0) {
        done_ = 0;
    } else if (known != steps_.end()) {
        done_ = static_cast<std::size_t>(known - steps_.begin()) + 1;
    } else {
        // A new step: what had been undone is gone.
        steps_.resize(done_);
        steps_.push_back({now, document_.undoText()});
        done_ = steps_.size();
    }
    emit changed();
}

void History::goTo(std::size_t done) {
    const auto wanted = static_cast<int>(std::min(done, steps_.size()));
    document_.travel(wanted - static_cast<int>(done_));
}

}  // namespace vestige
