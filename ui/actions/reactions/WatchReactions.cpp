#include "ui/actions/reactions/WatchReactions.h"

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Notices.h"
#include "ui/watch/EventWatch.h"

namespace vestige {

WatchReactions::WatchReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    bench_.actions.onTriggered("help.responsiveness", [this] { tell(); });
}

WatchReactions::~WatchReactions() = default;

void WatchReactions::tell() {
    if (!EventWatch::current()) {
        own_ = std::make_unique<EventWatch>();
        return bench_.notices.inform(
            tr("From now on it is measured how long the window takes to answer. Work on, then choose this "
               "again."));
    }
    emit bench_.notices.warned(EventWatch::current()->report(5).join("\n"));
}

}  // namespace vestige
