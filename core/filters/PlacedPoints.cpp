#include "core/filters/PlacedPoints.h"

#include <algorithm>

namespace vestige {

PointPlacer::PointPlacer(const CellLayout& layout, const PointSpan& points)
    : points_(points),
      shiftX_(_mm_cvtsi32_si128(static_cast<int>(layout.shiftX()))),
      shiftY_(_mm_cvtsi32_si128(static_cast<int>(layout.shiftY()))) {
    constexpr auto kSteps = static_cast<double>(std::uint64_t{1} << kFractionBits);
    const double perSize = 1 / layout.size();
    scale_ = kSteps * perSize;
    perStep_ = layout.size() / kSteps;
    for (int axis = 0; axis < 3; ++axis) {
        const double cells = points.origin[axis] * perSize - static_cast<double>(layout.base()[axis]);
        // Rounded to the step that it will have as part of a fixed-point number.
        shiftOfFixed_[axis] = kFixed + cells * kSteps;
        shift_[axis] = shiftOfFixed_[axis] - kFixed;
        most_[axis] = kFixed + static_cast<double>(layout.counts()[axis]) * kSteps - 1;
    }
}

PointPlacer::Four PointPlacer::placeLast(std::size_t i) const {
    FourOffsets offsets;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        alignas(32) std::array<double, 4> lanes{};
        for (std::size_t lane = 0; lane < 4; ++lane) {
            const std::size_t at = std::min(i + lane, points_.offsets.size() - 1);
            lanes[lane] = static_cast<double>(points_.offsets[at][static_cast<int>(axis)]);
            if (!points_.residuals.empty())
                lanes[lane] += static_cast<double>(points_.residuals[at][static_cast<int>(axis)]);
        }
        offsets.axes[axis] = _mm256_load_pd(lanes.data());
    }
    return place(offsets);
}

}  // namespace vestige
