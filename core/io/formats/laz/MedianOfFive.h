#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace vestige::laz {

/// A running median as LASzip has it: of five ordered numbers, the largest or the smallest goes when another
/// comes, by turns that depend on which side of the median it lies.
class MedianOfFive {
  public:
    std::int32_t median() const { return ordered_[2]; }
    void add(std::int32_t number) {
        const std::int32_t* kept = ordered_.data() + (dropLargest_ ? 0 : 1);
        const std::int32_t a = kept[0];
        const std::int32_t b = kept[1];
        const std::int32_t c = kept[2];
        const std::int32_t d = kept[3];
        dropLargest_ = dropLargest_ ? number < median() : number <= median();
        ordered_ = {std::min(a, number), std::max(a, std::min(b, number)), std::max(b, std::min(c, number)),
                    std::max(c, std::min(d, number)), std::max(d, number)};
    }

  private:
    std::array<std::int32_t, 5> ordered_{};
    bool dropLargest_ = true;
};

}  // namespace vestige::laz
