#include "core/filters/Objects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/Parallel.h"
#include "core/geometry/SortedKeys.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;
constexpr unsigned kAxisBits = 21;
constexpr std::uint64_t kMiddle = std::uint64_t{1} << (kAxisBits - 1);

/// x, y and z of a cube as one number; a step to a neighbour is a difference of keys.
std::uint64_t keyOf(const Eigen::Vector3f& place, float edge) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto steps = static_cast<std::int64_t>(std::floor(place[axis] / edge));
        const auto held = static_cast<std::uint64_t>(
            std::clamp<std::int64_t>(steps + static_cast<std::int64_t>(kMiddle), 1, 2 * kMiddle - 2));
        key = key << kAxisBits | held;
    }
    return key;
}

/// Which of many things belong together.
class Groups {
  public:
    explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }
    std::uint32_t of(std::uint32_t item) {
        while (parents_[item] != item) item = parents_[item] = parents_[parents_[item]];
        return item;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = of(a);
        b = of(b);
        if (a != b) parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parents_;
};

std::vector<std::uint32_t> standingPoints(const UprightPoints& points, const GroundSurface& ground,
                                          double highest_m) {
    std::vector<std::vector<std::uint32_t>> parts((points.size() + kGrain - 1) / kGrain);
    parallelChunks(points.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3f place = points[i];
            const float above = ground.heightAbove(place);
            if (above > ground.tolerance(place) && above <= static_cast<float>(highest_m))
                parts[chunk].push_back(static_cast<std::uint32_t>(i));
        }
    });
    std::vector<std::uint32_t> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// Joins each cube with those of its 26 neighbours that are there; `keys` ascend.
void joinNeighbours(const std::vector<std::uint64_t>& keys, Groups& groups) {
    // Half of the neighbours; the others find this one.
    std::vector<std::uint64_t> steps;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const std::int64_t step =
                    (std::int64_t{x} << (2 * kAxisBits)) + (std::int64_t{y} << kAxisBits) + z;
                if (step > 0) steps.push_back(static_cast<std::uint64_t>(step));
            }
    // Keys ascend, so the place of each neighbour does, too.
    for (const std::uint64_t step : steps) {
        std::size_t other = 0;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            while (other < keys.size() && keys[other] < keys[i] + step) ++other;
            if (other == keys.size()) break;
            if (keys[other] == keys[i] + step)
                groups.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(other));
        }
    }
}

FoundObject described(std::vector<std::uint32_t> own, const UprightPoints& points,
                      const GroundSurface& ground) {
    FoundObject object;
    object.points = std::move(own);
    std::vector<Eigen::Vector3f> places;
    places.reserve(object.points.size());
    float above = std::numeric_limits<float>::max();
    for (const std::uint32_t point : object.points) {
        places.push_back(points[point]);
        above = std::min(above, ground.heightAbove(places.back()));
    }
    object.box = uprightBox(places);
    object.above_m = static_cast<double>(above);
    object.kind = kindOf(object.box, object.above_m);
    return object;
}

}  // namespace

std::string kindOf(const UprightBox& box, double above_m) {
    const bool vehicle = box.length_m >= 2.2 && box.length_m <= 20 && box.width_m >= 1.2 &&
                         box.width_m <= 3.2 && box.height_m >= 0.8 && box.height_m <= 4.6 && above_m <= 0.6;
    if (vehicle) return "vehicle";
    if (box.height_m > 1.5 && box.height_m > 1.5 * box.width_m) return "vegetation";
    if (box.length_m <= 2.2 && box.height_m <= 1.5) return "debris";
    return "other";
}

Result<std::vector<FoundObject>> findObjects(const UprightPoints& points, const GroundSurface& ground,
                                             const ObjectOptions& options, const JobControl& control) {
    return guarded("objects", [&]() -> Result<std::vector<FoundObject>> {
        const auto step = [&](double share, const char* what) {
            if (control.cancelled()) throw ErrorException{cancelledError()};
            control.progress(share, what);
        };
        step(0, "what stands above the ground");
        const std::vector<std::uint32_t> standing = standingPoints(points, ground, options.highest_m);
        const auto edge = static_cast<float>(options.gap_m);
        step(0.2, "what hangs together");
        const auto sorted = sortedByKey<std::uint64_t>(
            standing.size(), 3 * kAxisBits, [&](std::size_t begin, std::span<std::uint64_t> keys) {
                for (std::size_t i = 0; i < keys.size(); ++i)
                    keys[i] = keyOf(points[standing[begin + i]], edge);
            });
        std::vector<std::uint64_t> cubes;
        std::vector<std::uint32_t> cubeOf(standing.size());
        for (const auto& item : sorted) {
            const std::uint64_t key = item.key;
            if (cubes.empty() || cubes.back() != key) cubes.push_back(key);
            cubeOf[item.index] = static_cast<std::uint32_t>(cubes.size() - 1);
        }
        step(0.5, "what hangs together");
        Groups groups(cubes.size());
        joinNeighbours(cubes, groups);
        std::vector<std::uint32_t> counts(cubes.size(), 0);
        for (const std::uint32_t cube : cubeOf) ++counts[groups.of(cube)];
        step(0.7, "what hangs together");
        constexpr std::uint32_t kPassedOver = std::numeric_limits<std::uint32_t>::max();
        std::vector<std::uint32_t> numbers(cubes.size(), kPassedOver);
        std::vector<std::vector<std::uint32_t>> members;
        for (std::size_t i = 0; i < standing.size(); ++i) {
            const std::uint32_t group = groups.of(cubeOf[i]);
            if (counts[group] < options.fewest) continue;
            if (numbers[group] == kPassedOver) {
                numbers[group] = static_cast<std::uint32_t>(members.size());
                members.emplace_back().reserve(counts[group]);
            }
            members[numbers[group]].push_back(standing[i]);
        }
        std::vector<FoundObject> found(members.size());
        parallelFor(members.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                found[i] = described(std::move(members[i]), points, ground);
        });
        step(0.9, "what hangs together");
        std::erase_if(found, [&](const FoundObject& object) {
            const double longest = std::max(object.box.length_m, object.box.height_m);
            return longest < options.smallest_m || longest > options.largest_m;
        });
        std::sort(found.begin(), found.end(), [](const FoundObject& a, const FoundObject& b) {
            return a.points.size() != b.points.size() ? a.points.size() > b.points.size()
                                                      : a.points.front() < b.points.front();
        });
        return found;
    });
}

}  // namespace vestige
