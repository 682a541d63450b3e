#include <algorithm>
#include <numeric>

#include "core/base/Parallel.h"
#include "core/io/formats/LasSource.h"

namespace vestige {
namespace {

/// What a range found out on its way.
struct Notes {
    std::uint64_t withheld = 0;
    std::uint16_t brightest = 0;

    void add(const LasPoint& point) {
        withheld += point.withheld ? 1 : 0;
        brightest = std::max({brightest, point.color[0], point.color[1], point.color[2]});
    }
};

bool inside(const BoundingBox& box, const Eigen::Vector3d& place) {
    return (place.array() >= box.min.array()).all() && (place.array() <= box.max.array()).all();
}

/// Every point's place is known before: threads fill the cloud directly.
void gatherAll(LasSource& source, std::span<const LasRange> ranges, std::uint64_t every, LasCloud& cloud) {
    std::vector<std::uint64_t> bases;
    std::uint64_t total = 0;
    for (const LasRange& range : ranges) {
        bases.push_back(total);
        total += range.size();
    }
    cloud.resize((total + every - 1) / every);
    std::vector<Notes> notes(ranges.size());
    const std::uint64_t whole =
        source.read(ranges, [&](std::size_t range, std::uint64_t first, std::span<const LasPoint> points) {
            std::uint64_t place = bases[range] + (first - ranges[range].begin);
            Notes& own = notes[range];
            for (const LasPoint& point : points) {
                if (every == 1) {
                    cloud.set(place, point);
                    own.add(point);
                } else if (place % every == 0) {
                    cloud.set(place / every, point);
                    own.add(point);
                }
                ++place;
            }
        });
    if (whole < total) cloud.resize((whole + every - 1) / every);
    for (const Notes& own : notes) cloud.note(own.withheld, own.brightest);
}

/// Which points lie in the box is known only after they were read.
void gatherInside(LasSource& source, std::span<const LasRange> ranges, const BoundingBox& box,
                  std::uint64_t every, LasCloud& cloud) {
    std::vector<std::vector<std::pair<std::uint64_t, LasPoint>>> found(ranges.size());
    const std::uint64_t whole =
        source.read(ranges, [&](std::size_t range, std::uint64_t first, std::span<const LasPoint> points) {
            for (std::size_t i = 0; i < points.size(); ++i)
                if (inside(box, lasPosition(source.header(), points[i].steps)))
                    found[range].emplace_back(first + i, points[i]);
        });
    std::uint64_t place = 0;
    std::uint64_t base = 0;
    for (std::size_t range = 0; range < ranges.size(); ++range) {
        const auto behindDamage = [&](const auto& entry) {
            return base + (entry.first - ranges[range].begin) >= whole;
        };
        std::erase_if(found[range], behindDamage);
        base += ranges[range].size();
        place += found[range].size();
    }
    cloud.resize((place + every - 1) / every);
    place = 0;
    Notes notes;
    for (auto& part : found) {
        for (const auto& [index, point] : part) {
            if (place % every == 0) {
                cloud.set(place / every, point);
                notes.add(point);
            }
            ++place;
        }
        part = {};
    }
    cloud.note(notes.withheld, notes.brightest);
}

}  // namespace

PointCloud gatherLas(LasSource& source, std::span<const LasRange> ranges, const ReadOptions& options,
                     ReadJob& job) {
    LasCloud cloud(source.header(), options.attributes);
    const std::uint64_t every = std::max<std::uint32_t>(1, options.keepEvery);
    if (options.box)
        gatherInside(source, ranges, *options.box, every, cloud);
    else
        gatherAll(source, ranges, every, cloud);
    return std::move(cloud).build(job);
}

}  // namespace vestige
