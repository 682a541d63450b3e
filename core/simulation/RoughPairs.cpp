#include "core/simulation/RoughPairs.h"

#include <algorithm>
#include <limits>

#include "core/base/Random.h"

namespace vestige {
namespace {

constexpr std::uint64_t kPairStream = 400;
constexpr std::size_t kPairs = 6;
constexpr double kTargetError_m = 0.020;
constexpr double kSourceError_m = 0.002;

Eigen::Vector3d error(Random& random, double sigma) {
    return {random.normal(0, sigma), random.normal(0, sigma), random.normal(0, sigma)};
}

/// Indices of places far from one another: first the one farthest from the middle, then always the one
/// farthest from those taken.
std::vector<std::size_t> spread(const std::vector<Eigen::Vector3d>& places, std::size_t count) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& place : places) middle += place / static_cast<double>(places.size());
    std::vector<double> distance(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) distance[i] = (places[i] - middle).norm();
    std::vector<std::size_t> taken;
    while (taken.size() < std::min(count, places.size())) {
        const auto next =
            static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
        if (taken.empty())
            std::fill(distance.begin(), distance.end(), std::numeric_limits<double>::infinity());
        taken.push_back(next);
        for (std::size_t i = 0; i < places.size(); ++i)
            distance[i] = std::min(distance[i], (places[i] - places[next]).norm());
    }
    return taken;
}

}  // namespace

Result<std::vector<RoughPair>> roughPairs(const HandheldScan& scan,
                                          const std::vector<std::uint32_t>& aerialCounts,
                                          const Eigen::Vector3d& worldFromSite, const std::string& layer,
                                          std::uint64_t seed) {
    std::uint32_t most = 0;
    for (const std::uint32_t count : aerialCounts) most = std::max(most, count);
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = 0; i < scan.sample.size(); ++i)
        if (aerialCounts[i] > 0 && 3 * aerialCounts[i] >= most) places.push_back(scan.sample[i].position);
    if (places.size() < 4)
        return fail(ErrorCode::input, "the aerial cloud shows too little of what this handheld layer scanned",
                    layer, "a longer flight, or sweeps that reach what the aircraft sees");
    const Similarity layerFromSite = scan.siteFromLayer.inverse();
    Random random(seed, kPairStream);
    std::vector<RoughPair> pairs;
    for (const std::size_t i : spread(places, kPairs))
        pairs.push_back({worldFromSite + places[i] + error(random, kTargetError_m),
                         layerFromSite * (places[i] + error(random, kSourceError_m))});
    return pairs;
}

}  // namespace vestige
