#include "core/registration/global/SurfelFeatures.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"
#include "core/registration/global/NeighbourCells.h"

namespace vestige {
namespace {

constexpr int kTwist = 10;  // bins of |v . n(q)|
constexpr int kRise = 11;   // of u . d
constexpr int kFold = 11;   // of the angle
constexpr std::size_t kFewNeighbours = 8;

using Histogram = std::array<float, kFeatureBins>;

/// Where each bin goes when the normal turns round.
constexpr std::array<std::uint8_t, kFeatureBins> kReversal = [] {
    std::array<std::uint8_t, kFeatureBins> to{};
    for (int bin = 0; bin < kTwist; ++bin) to[bin] = static_cast<std::uint8_t>(bin);
    for (int bin = 0; bin < kRise; ++bin)
        to[kTwist + bin] = static_cast<std::uint8_t>(kTwist + kRise - 1 - bin);
    for (int bin = 0; bin < kFold; ++bin)
        to[kTwist + kRise + bin] = static_cast<std::uint8_t>(kTwist + kRise + (kFold - bin) % kFold);
    return to;
}();

/// Grows with the angle of (x, y), x >= 0, from 0 at -90 degrees to 1 at 90 degrees.
float share(float x, float y) {
    const float sum = x + std::abs(y);
    return sum > 0 ? 0.5F + 0.5F * y / sum : 0.5F;
}

/// Adds the pair's three bins; false for a neighbour straight above or below.
bool addPair(const Eigen::Vector3f& u, const Eigen::Vector3f& d, const Eigen::Vector3f& normal,
             Histogram& histogram) {
    Eigen::Vector3f v = u.cross(d);
    const float length = v.norm();
    if (length < 1e-3F) return false;
    v /= length;
    const Eigen::Vector3f w = u.cross(v);
    const float twist = std::abs(v.dot(normal));
    const float rise = 0.5F + 0.5F * u.dot(d);
    float along = u.dot(normal);
    float across = w.dot(normal);
    if (along < 0) {
        along = -along;
        across = -across;
    }
    const int a = std::min(kTwist - 1, static_cast<int>(twist * kTwist));
    const int b = std::clamp(static_cast<int>(rise * kRise), 0, kRise - 1);
    // The angle is periodic: -90 and 90 degrees share a bin.
    const int c = static_cast<int>(share(along, across) * kFold + 0.5F) % kFold;
    histogram[a] += 1;
    histogram[kTwist + b] += 1;
    histogram[kTwist + kRise + c] += 1;
    return true;
}

/// The histogram of one surfel alone (SPFH), its bins summing to 1 three times; its bend. Zero where there
/// are too few neighbours.
struct Simple {
    std::vector<Histogram> histogram;
    std::vector<float> bend;
};

Simple simpleHistograms(const Surfels& surfels, const NeighbourCells& cells) {
    Simple simple{std::vector<Histogram>(surfels.size(), Histogram{}),
                  std::vector<float>(surfels.size(), 0.0F)};
    cells.forEach([&](std::uint32_t point, std::span<const NeighbourCells::Neighbour> near) {
        if (near.size() < kFewNeighbours) return;
        const Eigen::Vector3f u = surfels.normals[point];
        Histogram histogram{};
        float count = 0;
        float bend = 0;
        for (const auto& neighbour : near) {
            if (!(neighbour.squaredDistance > 0)) continue;
            const Eigen::Vector3f d = (surfels.points[neighbour.point] - surfels.points[point]) /
                                      std::sqrt(neighbour.squaredDistance);
            const Eigen::Vector3f& normal = surfels.normals[neighbour.point];
            const float turn = u.dot(normal);
            bend += 1 - turn * turn;
            count += addPair(u, d, normal, histogram);
        }
        if (count < kFewNeighbours) return;
        for (float& bin : histogram) bin /= count;
        simple.histogram[point] = histogram;
        simple.bend[point] = bend / static_cast<float>(near.size());
    });
    return simple;
}

SurfelFeature quantised(const Histogram& histogram) {
    SurfelFeature feature{};
    const auto part = [&](int first, int count) {
        float sum = 0;
        for (int bin = first; bin < first + count; ++bin) sum += histogram[bin];
        for (int bin = first; bin < first + count; ++bin)
            feature[bin] =
                static_cast<std::uint8_t>(sum > 0 ? 255 * std::sqrt(histogram[bin] / sum) + 0.5F : 0);
    };
    part(0, kTwist);
    part(kTwist, kRise);
    part(kTwist + kRise, kFold);
    return feature;
}

}  // namespace

SurfelFeature reversed(const SurfelFeature& feature) {
    SurfelFeature turned{};
    for (std::size_t bin = 0; bin < kFeatureBins; ++bin) turned[kReversal[bin]] = feature[bin];
    return turned;
}

SurfelFeatures featuresOf(const Surfels& surfels, double radius_m, double leastBend, std::size_t count) {
    const NeighbourCells cells(surfels.points, static_cast<float>(radius_m));
    const Simple simple = simpleHistograms(surfels, cells);
    std::vector<std::uint32_t> bent;
    for (std::uint32_t i = 0; i < surfels.size(); ++i)
        if (simple.bend[i] >= leastBend) bent.push_back(i);
    SurfelFeatures features;
    std::vector<std::uint32_t> place(surfels.size(), ~std::uint32_t{0});
    for (const std::uint32_t k : spreadIndices(bent.size(), count)) {
        place[bent[k]] = static_cast<std::uint32_t>(features.surfel.size());
        features.surfel.push_back(bent[k]);
    }
    features.feature.resize(features.surfel.size());
    cells.forEach([&](std::uint32_t point, std::span<const NeighbourCells::Neighbour> near) {
        if (place[point] == ~std::uint32_t{0}) return;
        Histogram sum = simple.histogram[point];
        const Eigen::Vector3f u = surfels.normals[point];
        const float count_ = static_cast<float>(near.size());
        for (const auto& neighbour : near) {
            const float turn = u.dot(surfels.normals[neighbour.point]);
            const float weight = std::abs(turn) * static_cast<float>(surfels.voxel_m) /
                                 (count_ * std::sqrt(std::max(neighbour.squaredDistance, 1e-12F)));
            const Histogram& other = simple.histogram[neighbour.point];
            if (turn >= 0)
                for (std::size_t bin = 0; bin < kFeatureBins; ++bin) sum[bin] += weight * other[bin];
            else
                for (std::size_t bin = 0; bin < kFeatureBins; ++bin)
                    sum[kReversal[bin]] += weight * other[bin];
        }
        features.feature[place[point]] = quantised(sum);
    });
    return features;
}

}  // namespace vestige
