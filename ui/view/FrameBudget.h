#pragma once

#include <algorithm>
#include <cstddef>

namespace vestige {

/// How many points a frame may draw so that it takes the time wished for; follows what frames take.
class FrameBudget {
  public:
    explicit FrameBudget(double seconds) : seconds_(seconds) {}

    std::size_t points() const { return static_cast<std::size_t>(points_); }

    void frameTook(std::size_t points, double seconds) {
        const bool full = static_cast<double>(points) > 0.5 * points_;
        if (!full && seconds <= seconds_) return;
        const double factor = std::clamp(seconds_ / std::max(seconds, 1e-4), 0.4, 1.6);
        points_ = std::clamp(points_ * factor, kLeast, kMost);
    }

  private:
    static constexpr double kLeast = 5e4;
    static constexpr double kMost = 1e8;
    double seconds_;
    double points_ = 2e5;
};

}  // namespace vestige
