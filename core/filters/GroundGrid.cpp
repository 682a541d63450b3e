#include "core/filters/GroundGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kFar = std::numeric_limits<float>::infinity();

/// Running least (or, with `sign` -1, greatest) value over 2 radius + 1 neighbours of each of a line's
/// values.
void runningLeast(std::vector<float>& line, int radius, std::vector<float>& forward,
                  std::vector<float>& backward) {
    const int count = static_cast<int>(line.size());
    const int window = 2 * radius + 1;
    const int padded = count + 2 * radius;
    const auto at = [&](int i) {
        const int place = i - radius;
        return place >= 0 && place < count ? line[static_cast<std::size_t>(place)] : kFar;
    };
    forward.resize(static_cast<std::size_t>(padded));
    backward.resize(static_cast<std::size_t>(padded));
    for (int i = 0; i < padded; ++i) {
        const auto here = static_cast<std::size_t>(i);
        forward[here] = i % window == 0 ? at(i) : std::min(forward[here - 1], at(i));
    }
    for (int i = padded - 1; i >= 0; --i) {
        const auto here = static_cast<std::size_t>(i);
        backward[here] =
            i == padded - 1 || (i + 1) % window == 0 ? at(i) : std::min(backward[here + 1], at(i));
    }
    for (int i = 0; i < count; ++i)
        line[static_cast<std::size_t>(i)] = std::min(backward[static_cast<std::size_t>(i)],
                                                     forward[static_cast<std::size_t>(i + window - 1)]);
}

/// Over squares, of the values times `sign`; infinite values are empty.
void least(std::vector<float>& values, int columns, int rows, int radius) {
    const auto width = static_cast<std::size_t>(columns);
    const auto height = static_cast<std::size_t>(rows);
    parallelFor(height, 64, [&](std::size_t begin, std::size_t end) {
        std::vector<float> line(width), forward, backward;
        for (std::size_t row = begin; row < end; ++row) {
            std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(row * width), width, line.begin());
            runningLeast(line, radius, forward, backward);
            std::copy_n(line.begin(), width, values.begin() + static_cast<std::ptrdiff_t>(row * width));
        }
    });
    parallelFor(width, 64, [&](std::size_t begin, std::size_t end) {
        std::vector<float> line(height), forward, backward;
        for (std::size_t column = begin; column < end; ++column) {
            for (std::size_t row = 0; row < height; ++row) line[row] = values[row * width + column];
            runningLeast(line, radius, forward, backward);
            for (std::size_t row = 0; row < height; ++row) values[row * width + column] = line[row];
        }
    });
}

}  // namespace

GroundGrid::GroundGrid(const Eigen::Vector2f& corner, float cell, int columns, int rows)
    : heights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kNone),
      corner_(corner),
      cell_(cell),
      columns_(columns),
      rows_(rows) {}

std::size_t GroundGrid::index(float x, float y) const {
    const int column = std::clamp(static_cast<int>((x - corner_.x()) / cell_), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>((y - corner_.y()) / cell_), 0, rows_ - 1);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
}

Eigen::Vector2f GroundGrid::centre(std::size_t index) const {
    const auto width = static_cast<std::size_t>(columns_);
    return corner_ + cell_ * Eigen::Vector2f(static_cast<float>(index % width) + 0.5F,
                                             static_cast<float>(index / width) + 0.5F);
}

void openHeights(std::vector<float>& heights, int columns, int rows, int radius) {
    std::vector<float> values(heights.size());
    std::transform(heights.begin(), heights.end(), values.begin(),
                   [](float height) { return std::isnan(height) ? kFar : height; });
    least(values, columns, rows, radius);
    for (float& value : values) value = std::isinf(value) ? kFar : -value;
    least(values, columns, rows, radius);
    for (std::size_t i = 0; i < heights.size(); ++i)
        if (!std::isnan(heights[i])) heights[i] = -values[i];
}

void fillHeights(std::vector<float>& heights, int columns, int rows) {
    const bool whole =
        std::none_of(heights.begin(), heights.end(), [](float height) { return std::isnan(height); });
    if (whole || (columns == 1 && rows == 1)) return;
    const int halfColumns = (columns + 1) / 2;
    const int halfRows = (rows + 1) / 2;
    const auto width = static_cast<std::size_t>(columns);
    const auto halfWidth = static_cast<std::size_t>(halfColumns);
    std::vector<float> half(halfWidth * static_cast<std::size_t>(halfRows), kNone);
    for (std::size_t row = 0; row < static_cast<std::size_t>(halfRows); ++row)
        for (std::size_t column = 0; column < halfWidth; ++column) {
            double sum = 0;
            int count = 0;
            for (std::size_t y = 2 * row; y < std::min(2 * row + 2, static_cast<std::size_t>(rows)); ++y)
                for (std::size_t x = 2 * column; x < std::min(2 * column + 2, width); ++x)
                    if (const float height = heights[y * width + x]; !std::isnan(height)) {
                        sum += static_cast<double>(height);
                        ++count;
                    }
            if (count > 0) half[row * halfWidth + column] = static_cast<float>(sum / count);
        }
    fillHeights(half, halfColumns, halfRows);
    // Between the middles of the larger squares, or slopes would be filled with steps.
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
        for (std::size_t column = 0; column < width; ++column) {
            float& height = heights[row * width + column];
            if (!std::isnan(height)) continue;
            const float x = std::clamp(0.5F * static_cast<float>(column) - 0.25F, 0.0F,
                                       static_cast<float>(halfColumns - 1));
            const float y =
                std::clamp(0.5F * static_cast<float>(row) - 0.25F, 0.0F, static_cast<float>(halfRows - 1));
            const auto x0 = static_cast<std::size_t>(x);
            const auto y0 = static_cast<std::size_t>(y);
            const std::size_t x1 = std::min(x0 + 1, halfWidth - 1);
            const std::size_t y1 = std::min(y0 + 1, static_cast<std::size_t>(halfRows) - 1);
            const float u = x - static_cast<float>(x0);
            const float v = y - static_cast<float>(y0);
            height = (1 - v) * ((1 - u) * half[y0 * halfWidth + x0] + u * half[y0 * halfWidth + x1]) +
                     v * ((1 - u) * half[y1 * halfWidth + x0] + u * half[y1 * halfWidth + x1]);
        }
}

}  // namespace vestige
