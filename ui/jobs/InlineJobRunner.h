#pragma once

#include "ui/jobs/JobRunner.h"

namespace vestige {

/// Runs each job at once on the calling thread and delivers before `run` returns: for command lines that want
/// the window's picture, and for tests. A job started while another runs waits until that has delivered.
class InlineJobRunner : public JobRunner {
    Q_OBJECT

  public:
    using JobRunner::JobRunner;
    bool immediate() const override { return true; }
    bool busy() const override { return running_; }
    void cancel() override;

  protected:
    void enqueue(Job job) override;
    void post(std::function<void()> task) override;

  private:
    std::vector<Job> waiting_;
    JobControl control_;
    bool running_ = false;
    bool cancelWaiting_ = false;
};

}  // namespace vestige
