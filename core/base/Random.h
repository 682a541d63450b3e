#pragma once

#include <cstdint>

namespace vestige {

/// Pseudo-random numbers that are the same on every machine and compiler (SplitMix64; Steele, Lea, Flood
/// 2014). One per item, seeded with (seed, item), keeps parallel simulations independent of threads.
class Random {
  public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

    std::uint64_t bits();
    /// Uniform in [0, 1).
    double uniform();
    double uniform(double from, double to) { return from + (to - from) * uniform(); }
    /// Uniform in 0 ... count - 1.
    std::uint64_t below(std::uint64_t count);
    /// Standard normal (Marsaglia's polar method).
    double normal();
    double normal(double mean, double sigma) { return mean + sigma * normal(); }

  private:
    std::uint64_t state_;
    double spare_ = 0;
    bool hasSpare_ = false;
};

}  // namespace vestige
