#pragma once

#include <QString>
#include <optional>

namespace vestige {

/// Estimates when a job ends, from the share of it that is done, and how fast that grew since the start and
/// of late. A job's shares are rough, so the estimate follows what they say only slowly, and counts down
/// meanwhile. Times in seconds of any clock that runs on; the caller's.
class TimeLeft {
  public:
    explicit TimeLeft(double start_s) : start_s_(start_s), asked_s_(start_s) {}

    /// Reported now; also called without news, so that a share that does not grow is noticed. A share that
    /// falls back begins a new estimate.
    void update(double now_s, double share);
    /// Nothing in the first second, and while less than 2 % is done: nobody can tell yet.
    std::optional<double> left_s(double now_s) const;

  private:
    double start_s_;
    double asked_s_;
    double share_ = 0;
    std::optional<double> rate_;  ///< share a second, of late
    std::optional<double> end_s_;
};

/// "12 s left", "about 40 s left", "3 min left".
QString timeLeftText(double seconds);

}  // namespace vestige
