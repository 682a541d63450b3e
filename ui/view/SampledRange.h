#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vestige {

/// Quantiles of many values from an even sample of them.
class SampledRange {
  public:
    /// Of so many values every k-th is looked at.
    static std::size_t stride(std::size_t count) { return std::max<std::size_t>(1, count / 50000); }
    /// Values that are not finite do not count.
    template <class Value>
    void sample(std::size_t count, const Value& value) {
        for (std::size_t i = 0; i < count; i += stride(count)) {
            const double one = value(i);
            if (std::isfinite(one)) values_.push_back(one);
        }
    }
    bool empty() const { return values_.empty(); }
    /// Not for an empty sample.
    double quantile(double share) {
        const auto place =
            values_.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values_.size() - 1));
        std::nth_element(values_.begin(), place, values_.end());
        return *place;
    }

  private:
    std::vector<double> values_;
};

}  // namespace vestige
