#include "core/geometry/OutlineMask.h"

#include <algorithm>
#include <cmath>

namespace vestige {

OutlineMask::OutlineMask(std::span<const Eigen::Vector2d> corners, int width, int height)
    : width_(std::max(0, width)), height_(std::max(0, height)) {
    sums_.assign((static_cast<std::size_t>(width_) + 1) * (static_cast<std::size_t>(height_) + 1), 0);
    fillRows(corners);
    const std::size_t stride = static_cast<std::size_t>(width_) + 1;
    for (std::size_t row = 1; row <= static_cast<std::size_t>(height_); ++row) {
        std::uint32_t here = 0;
        for (std::size_t column = 1; column < stride; ++column) {
            std::uint32_t& sum = sums_[row * stride + column];
            here += sum;
            sum = here + sums_[(row - 1) * stride + column];
        }
    }
}

void OutlineMask::fillRows(std::span<const Eigen::Vector2d> corners) {
    if (corners.size() < 3) return;
    const std::size_t stride = static_cast<std::size_t>(width_) + 1;
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(height_));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Eigen::Vector2d a = corners[i];
        Eigen::Vector2d b = corners[(i + 1) % corners.size()];
        if (!a.allFinite() || !b.allFinite()) continue;
        if (a.y() > b.y()) std::swap(a, b);
        // Rows whose centre lies in [a.y, b.y).
        const double first = std::max(0.0, std::ceil(a.y() - 0.5));
        const double last = std::min(static_cast<double>(height_), std::ceil(b.y() - 0.5));
        for (double row = first; row < last; ++row) {
            const double share = (row + 0.5 - a.y()) / (b.y() - a.y());
            crossings[static_cast<std::size_t>(row)].push_back(a.x() + share * (b.x() - a.x()));
        }
    }
    const auto columnOf = [&](double x) {
        return static_cast<std::size_t>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width_)));
    };
    for (std::size_t row = 0; row < crossings.size(); ++row) {
        std::vector<double>& here = crossings[row];
        std::sort(here.begin(), here.end());
        for (std::size_t k = 0; k + 1 < here.size(); k += 2)
            for (std::size_t column = columnOf(here[k]); column < columnOf(here[k + 1]); ++column)
                sums_[(row + 1) * stride + column + 1] = 1;
    }
}

OutlineMask::Cover OutlineMask::cover(const Eigen::Vector2d& least, const Eigen::Vector2d& most) const {
    if (!(least.x() < width_ && least.y() < height_ && most.x() >= 0 && most.y() >= 0)) return Cover::none;
    const bool whole = least.x() >= 0 && least.y() >= 0 && most.x() < width_ && most.y() < height_;
    const int x0 = std::max(0, static_cast<int>(std::floor(std::max(least.x(), 0.0))));
    const int y0 = std::max(0, static_cast<int>(std::floor(std::max(least.y(), 0.0))));
    const int x1 = std::min(width_, static_cast<int>(std::min(most.x(), width_ - 1.0)) + 1);
    const int y1 = std::min(height_, static_cast<int>(std::min(most.y(), height_ - 1.0)) + 1);
    const std::uint32_t within = count(x0, y0, x1, y1);
    if (within == 0) return Cover::none;
    const auto area = static_cast<std::uint32_t>(x1 - x0) * static_cast<std::uint32_t>(y1 - y0);
    return whole && within == area ? Cover::all : Cover::part;
}

}  // namespace vestige
