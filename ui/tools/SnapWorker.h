#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "core/base/Result.h"
#include "core/measurement/FittedFeature.h"

namespace vestige {

/// Fits features away from the GUI thread, beside the jobs: a pick must not wait for a registration. One
/// after the other; what is asked while hovering gives way to what is asked later.
class SnapWorker : public QObject {
    Q_OBJECT

  public:
    using Fit = std::function<Result<FittedFeature>()>;
    using Answer = std::function<void(const Result<FittedFeature>&)>;

    explicit SnapWorker(QObject* parent = nullptr);
    /// Waits for the fit that is being made; answers that are not given yet never come.
    ~SnapWorker() override;

    /// `answer` gets what `fit` returned, on the thread of this object. `passing`: dropped, and never
    /// answered, when something is asked before its turn.
    void ask(Fit fit, Answer answer, bool passing);

  private:
    struct Task {
        Fit fit;
        Answer answer;
        bool passing = false;
    };
    void work();

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Task> waiting_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace vestige
