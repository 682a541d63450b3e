#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/base/JobControl.h"
#include "core/base/Result.h"

namespace vestige {

/// Runs heavy work away from the GUI thread, one job after the other in the order of their start. What a job
/// computed is delivered on the thread that owns the runner (the GUI thread). No exception crosses threads:
/// it becomes the Error of the job's Result.
class JobRunner : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// `work` runs elsewhere and must not touch widgets; `done` gets its Result on the GUI thread, also when
    /// it failed or was cancelled (ErrorCode::cancelled).
    template <class T>
    void run(const QString& title, std::function<Result<T>(const JobControl&)> work,
             std::function<void(Result<T>)> done) {
        enqueue({title, [title, work = std::move(work), done = std::move(done)](const JobControl& control) {
                     auto result =
                         std::make_shared<Result<T>>(guarded(title.toStdString(), [&]() -> Result<T> {
                             if (control.cancelled()) return fail(cancelledError());
                             return work(control);
                         }));
                     return std::function<void()>([result, done, control] {
                         // Cancelled between the end of the work and here: what the user stopped does not
                         // happen.
                         if (control.cancelled()) *result = fail(cancelledError());
                         done(std::move(*result));
                     });
                 }});
    }

    /// As run(); `work` can also hand over parts of what it computes, which `part` gets on the GUI thread in
    /// the order they were handed over, all before `done`. After cancelling no part is delivered.
    template <class T, class Part>
    void runInParts(const QString& title,
                    std::function<Result<T>(const JobControl&, const std::function<void(Part)>&)> work,
                    std::function<void(Part)> part, std::function<void(Result<T>)> done) {
        run<T>(
            title,
            [this, work = std::move(work), part = std::move(part)](const JobControl& control) {
                return work(control, [this, part, control](Part value) {
                    post([part, control, value = std::make_shared<Part>(std::move(value))] {
                        if (!control.cancelled()) part(std::move(*value));
                    });
                });
            },
            std::move(done));
    }

    /// Every job is done when `run` returns.
    virtual bool immediate() const { return false; }
    /// A job runs or waits.
    virtual bool busy() const = 0;
    /// Asks the running job to stop and drops the waiting ones; each still delivers its `done`.
    virtual void cancel() = 0;

  signals:
    /// A job was handed in while none ran; `busy` is true from now on. `finished` tells of the end.
    void becameBusy();
    void started(const QString& title);
    void progressed(double fraction, const QString& step);
    void messaged(const QString& sentence);
    /// After the result was delivered.
    void finished(const QString& title);

  protected:
    /// Computes, and returns what hands over the result.
    struct Job {
        QString title;
        std::function<std::function<void()>(const JobControl&)> work;
    };
    virtual void enqueue(Job job) = 0;
    /// Has this done on the GUI thread, after what was posted before; called while a job works.
    virtual void post(std::function<void()> task) = 0;
};

}  // namespace vestige
