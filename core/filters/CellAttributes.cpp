#include "core/filters/CellAttributes.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kCellGrain = 4096;

/// value(points of the cell) for every cell, where the cloud has the attribute `all`.
template <class Array, class ValueOf>
Array perCell(const Array& all, const CellMembers& cells, const ValueOf& valueOf) {
    Array values;
    if (all.empty()) return values;
    values.resize(cells.cellCount());
    parallelFor(cells.cellCount(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) values[cell] = valueOf(cells.points(cell));
    });
    return values;
}

/// The mean over each cell's points, where the cloud has the attribute `all`.
template <class Values>
std::vector<typename Values::value_type> means(const Values& all, const CellMembers& cells) {
    std::vector<typename Values::value_type> values;
    if (all.empty()) return values;
    values.resize(cells.cellCount());
    parallelFor(cells.cellCount(), kCellGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            const std::span<const std::uint32_t> points = cells.points(cell);
            // Differences from the first keep the digits of large values such as GPS time.
            const auto first = static_cast<double>(all[points.front()]);
            double sum = 0;
            for (const std::uint32_t point : points) sum += static_cast<double>(all[point]) - first;
            values[cell] =
                static_cast<typename Values::value_type>(first + sum / static_cast<double>(points.size()));
        }
    });
    return values;
}

template <class Value>
std::vector<Value> mostFrequent(const std::vector<Value>& all, const CellMembers& cells) {
    return perCell(all, cells, [&](std::span<const std::uint32_t> points) {
        thread_local std::vector<Value> held;
        held.clear();
        for (const std::uint32_t point : points) held.push_back(all[point]);
        std::sort(held.begin(), held.end());
        Value best = held.front();
        std::ptrdiff_t most = 0;
        for (auto run = held.begin(); run != held.end();) {
            const auto next = std::upper_bound(run, held.end(), *run);
            if (next - run > most) {
                most = next - run;
                best = *run;
            }
            run = next;
        }
        return best;
    });
}

}  // namespace

PointAttributes averagedAttributes(const PointAttributes& attributes, const CellMembers& cells) {
    PointAttributes averaged;
    averaged.intensity = means(attributes.intensity, cells);
    averaged.gpsTime = means(attributes.gpsTime, cells);
    averaged.color = perCell(attributes.color, cells, [&](std::span<const std::uint32_t> points) {
        std::array<std::uint64_t, 3> sum{};
        for (const std::uint32_t point : points)
            for (std::size_t channel = 0; channel < 3; ++channel)
                sum[channel] += attributes.color[point][channel];
        Color mean{};
        for (std::size_t channel = 0; channel < 3; ++channel)
            mean[channel] = static_cast<std::uint16_t>((sum[channel] + points.size() / 2) / points.size());
        return mean;
    });
    averaged.normal = perCell(attributes.normal, cells, [&](std::span<const std::uint32_t> points) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const std::uint32_t point : points) sum += attributes.normal[point].cast<double>();
        const double length = sum.norm();
        // What is left of normals that point both ways is rounding, not a direction.
        if (length <= 1e-6 * static_cast<double>(points.size())) return Eigen::Vector3f(0, 0, 0);
        return Eigen::Vector3f((sum / length).cast<float>());
    });
    averaged.classification = mostFrequent(attributes.classification, cells);
    averaged.pointSource = mostFrequent(attributes.pointSource, cells);
    averaged.returnNumber = mostFrequent(attributes.returnNumber, cells);
    averaged.returnCount = mostFrequent(attributes.returnCount, cells);
    return averaged;
}

}  // namespace vestige
