#pragma once

#include <memory>

#include "ui/jobs/JobRunner.h"

namespace vestige {

/// One worker thread. Destroyed, it asks the running job to stop, waits for it, and delivers nothing more.
class ThreadedJobRunner : public JobRunner {
    Q_OBJECT

  public:
    explicit ThreadedJobRunner(QObject* parent = nullptr);
    ~ThreadedJobRunner() override;
    bool busy() const override;
    void cancel() override;

  protected:
    void enqueue(Job job) override;
    void post(std::function<void()> task) override;

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace vestige
