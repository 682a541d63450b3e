#include "ui/watch/WatchedApplication.h"

#include <exception>
#include <iostream>
#include <new>

#include "ui/watch/EventWatch.h"

namespace vestige {
namespace {

void tell(const char* what) {
    std::cerr << "vestige: " << what << '\n';
}

}  // namespace

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
    const WatchedEvent watched(*receiver, *event);
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::bad_alloc&) {
        tell("there is not enough memory for this");
    } catch (const std::exception& error) {
        tell(error.what());
    }
    return false;
}

}  // namespace vestige
