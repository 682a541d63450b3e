#include "ui/shell/GuiThreadRenderer.h"

#include <QThread>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

namespace vestige {
namespace {

struct Picture {
    std::mutex mutex;
    std::condition_variable changed;
    bool begun = false;
    bool abandoned = false;
    std::optional<Status> status;
};

}  // namespace

GuiThreadRenderer::GuiThreadRenderer(ViewRenderer& renderer, QObject* parent)
    : QObject(parent), renderer_(renderer) {}

Status GuiThreadRenderer::renderPng(const ViewDescription& view, const std::filesystem::path& png,
                                    const JobControl& control) {
    if (QThread::currentThread() == thread()) return renderer_.renderPng(view, png, control);
    const auto picture = std::make_shared<Picture>();
    QMetaObject::invokeMethod(
        this,
        [this, picture, view, png, control] {
            {
                const std::lock_guard lock(picture->mutex);
                if (picture->abandoned) return;
                picture->begun = true;
            }
            Status status = guarded(png.string(), [&] { return renderer_.renderPng(view, png, control); });
            const std::lock_guard lock(picture->mutex);
            picture->status = std::move(status);
            picture->changed.notify_all();
        },
        Qt::QueuedConnection);
    std::unique_lock lock(picture->mutex);
    while (!picture->status) {
        picture->changed.wait_for(lock, std::chrono::milliseconds(50));
        if (!picture->begun && control.cancelled()) {
            picture->abandoned = true;
            return fail(cancelledError());
        }
    }
    return *picture->status;
}

}  // namespace vestige
