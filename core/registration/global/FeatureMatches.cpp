#include "core/registration/global/FeatureMatches.h"

#include <immintrin.h>

#include <algorithm>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kSourceGrain = 16;

/// The nearest found so far, nearest first.
struct Best {
    std::uint32_t distance = ~std::uint32_t{0};
    std::uint32_t target = ~std::uint32_t{0};
};

void insert(std::vector<Best>& best, std::uint32_t distance, std::uint32_t target) {
    if (distance >= best.back().distance) return;
    std::size_t at = best.size() - 1;
    for (; at > 0 && best[at - 1].distance > distance; --at) best[at] = best[at - 1];
    best[at] = {distance, target};
}

std::uint32_t distanceOf(__m256i a, const SurfelFeature& b) {
    const __m256i other = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(b.data()));
    const __m256i sums = _mm256_sad_epu8(a, other);
    const __m128i half = _mm_add_epi64(_mm256_castsi256_si128(sums), _mm256_extracti128_si256(sums, 1));
    return static_cast<std::uint32_t>(_mm_cvtsi128_si64(half) + _mm_extract_epi64(half, 1));
}

}  // namespace

std::vector<SurfelMatch> matchFeatures(const SurfelFeatures& target, const SurfelFeatures& source,
                                       std::size_t perSource) {
    perSource = std::min(perSource, target.feature.size());
    std::vector<std::vector<SurfelMatch>> parts((source.feature.size() + kSourceGrain - 1) / kSourceGrain);
    if (perSource == 0) return {};
    parallelChunks(
        source.feature.size(), kSourceGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            std::vector<std::vector<Best>> best(end - begin, std::vector<Best>(perSource));
            constexpr std::size_t kBlock = 512;  // target features that stay in the nearest cache
            for (std::size_t from = 0; from < target.feature.size(); from += kBlock) {
                const std::size_t to = std::min(target.feature.size(), from + kBlock);
                for (std::size_t i = begin; i < end; ++i) {
                    const SurfelFeature turned = reversed(source.feature[i]);
                    const __m256i one =
                        _mm256_loadu_si256(reinterpret_cast<const __m256i*>(source.feature[i].data()));
                    const __m256i two = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(turned.data()));
                    std::vector<Best>& mine = best[i - begin];
                    std::uint32_t limit = mine.back().distance;
                    for (std::size_t t = from; t < to; ++t) {
                        const std::uint32_t distance =
                            std::min(distanceOf(one, target.feature[t]), distanceOf(two, target.feature[t]));
                        if (distance >= limit) continue;
                        insert(mine, distance, static_cast<std::uint32_t>(t));
                        limit = mine.back().distance;
                    }
                }
            }
            for (std::size_t i = begin; i < end; ++i)
                for (const Best& one : best[i - begin])
                    if (one.target != ~std::uint32_t{0})
                        parts[chunk].push_back({source.surfel[i], target.surfel[one.target], one.distance});
        });
    std::vector<SurfelMatch> matches;
    for (const auto& part : parts) matches.insert(matches.end(), part.begin(), part.end());
    return matches;
}

}  // namespace vestige
