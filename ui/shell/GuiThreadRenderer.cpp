#include "ui/shell/GuiThreadRenderer.h"

#include <QImage>
#include <QThread>
#include <QTimer>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

#include "ui/view/PngFile.h"
#include "ui/view/SteppedRenderer.h"
#include "ui/watch/WatchedTime.h"

namespace vestige {

/// One picture, between the worker that waits for it and the thread that draws it.
struct GuiThreadRenderer::Picture {
    ViewDescription view;
    std::filesystem::path png;
    JobControl control;
    std::mutex mutex;
    std::condition_variable changed;
    bool abandoned = false;
    std::optional<Result<QImage>> drawn;  ///< a null image where the file is written already

    bool wanted() {
        const std::lock_guard lock(mutex);
        return !abandoned;
    }
    void end(Result<QImage> result) {
        const std::lock_guard lock(mutex);
        drawn = std::move(result);
        changed.notify_all();
    }
};

GuiThreadRenderer::GuiThreadRenderer(ViewRenderer& renderer, QObject* parent)
    : QObject(parent), renderer_(renderer), steps_(dynamic_cast<SteppedRenderer*>(&renderer)) {}

Status GuiThreadRenderer::renderPng(const ViewDescription& view, const std::filesystem::path& png,
                                    const JobControl& control) {
    if (QThread::currentThread() == thread()) return renderer_.renderPng(view, png, control);
    const auto picture = std::make_shared<Picture>();
    picture->view = view;
    picture->png = png;
    picture->control = control;
    control.progress(0, "drawing " + png.filename().string());
    QMetaObject::invokeMethod(
        this, [this, picture] { begin(picture); }, Qt::QueuedConnection);
    std::unique_lock lock(picture->mutex);
    while (!picture->drawn) {
        picture->changed.wait_for(lock, std::chrono::milliseconds(50));
        if (control.cancelled()) {
            picture->abandoned = true;
            return fail(cancelledError());
        }
    }
    if (!*picture->drawn) return fail(picture->drawn->error());
    return (*picture->drawn)->isNull() ? Status() : writePng(**picture->drawn, png);
}

void GuiThreadRenderer::begin(const std::shared_ptr<Picture>& picture) {
    if (!picture->wanted()) return;
    const WatchedTime watched("beginning a picture");
    const std::string place = picture->png.string();
    if (steps_) {
        const Status begun = guarded(place, [&] { return steps_->begin(picture->view, place); });
        if (!begun) return picture->end(fail(begun.error()));
        return step(picture);
    }
    const Status done =
        guarded(place, [&] { return renderer_.renderPng(picture->view, picture->png, picture->control); });
    picture->end(done ? Result<QImage>(QImage()) : Result<QImage>(fail(done.error())));
}

/// Another step comes as an event of its own, after those that wait.
void GuiThreadRenderer::step(const std::shared_ptr<Picture>& picture) {
    QTimer::singleShot(0, this, [this, picture] {
        if (!picture->wanted()) return;
        const WatchedTime watched("drawing a picture");
        using Drawn = std::optional<Result<QImage>>;
        auto drawn = guarded(picture->png.string(), [&]() -> Result<Drawn> { return steps_->step(); });
        if (!drawn) return picture->end(fail(drawn.error()));
        picture->control.progress(steps_->share());
        if (!*drawn) return step(picture);
        picture->end(std::move(**drawn));
    });
}

}  // namespace vestige
