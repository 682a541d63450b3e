#include <algorithm>

#include "core/base/Parallel.h"
#include "core/io/formats/LasSource.h"

namespace vestige {
namespace {

LasNotes sumOf(std::span<const LasNotes> parts) {
    LasNotes sum;
    for (const LasNotes& part : parts) sum.add(part);
    return sum;
}

std::uint64_t sizeOf(std::span<const LasRange> ranges) {
    std::uint64_t total = 0;
    for (const LasRange& range : ranges) total += range.size();
    return total;
}

/// The first `points` points of the ranges.
std::vector<LasRange> beginningOf(std::span<const LasRange> ranges, std::uint64_t points) {
    std::vector<LasRange> first;
    for (const LasRange& range : ranges) {
        const std::uint64_t many = std::min(points, range.size());
        if (many > 0) first.push_back({range.begin, range.begin + many});
        points -= many;
    }
    return first;
}

/// Every point's place is known before: threads fill the cloud directly. Of a salvaged source that met
/// damage, what is whole is read again, so that nothing of the rest is left in the cloud.
LasNotes gatherAll(LasSource& source, std::span<const LasRange> ranges, const ReadOptions& options,
                   LasCloud& cloud, bool exact) {
    const std::uint64_t every = std::max<std::uint32_t>(1, options.keepEvery);
    std::vector<std::uint64_t> bases;
    std::uint64_t total = 0;
    for (const LasRange& range : ranges) {
        bases.push_back(total);
        total += range.size();
    }
    cloud.resize((total + every - 1) / every);
    std::vector<LasNotes> notes(ranges.size());
    const bool bare = !source.header().compressed && every == 1 && !exact &&
                      options.attributes == ReadOptions::Attributes::drawn;
    if (bare) {
        source.readRecords(
            ranges, [&](std::size_t range, std::uint64_t first, const std::byte* records, std::size_t count) {
                cloud.setRecords(bases[range] + (first - ranges[range].begin), records, count, notes[range]);
            });
        return sumOf(notes);
    }
    const std::uint64_t whole =
        source.read(ranges, [&](std::size_t range, std::uint64_t first, std::span<const LasPoint> points) {
            std::uint64_t place = bases[range] + (first - ranges[range].begin);
            for (const LasPoint& point : points) {
                if (place % every == 0) {
                    cloud.set(place / every, point);
                    notes[range].add(point);
                }
                ++place;
            }
        });
    if (whole < total) return gatherAll(source, beginningOf(ranges, whole), options, cloud, exact);
    return sumOf(notes);
}

/// Which points lie in the box is known only after they were looked at: they are counted first, then read
/// again, which takes no memory but theirs.
LasNotes gatherInside(LasSource& source, std::span<const LasRange> ranges, const ReadOptions& options,
                      LasCloud& cloud) {
    const std::uint64_t every = std::max<std::uint32_t>(1, options.keepEvery);
    const auto inBox = [&](const LasPoint& point) {
        return options.box->contains(lasPosition(source.header(), point.steps));
    };
    std::vector<std::uint64_t> counts(ranges.size());
    const std::uint64_t whole =
        source.read(ranges, [&](std::size_t range, std::uint64_t, std::span<const LasPoint> points) {
            counts[range] += static_cast<std::uint64_t>(std::count_if(points.begin(), points.end(), inBox));
        });
    if (whole < sizeOf(ranges)) return gatherInside(source, beginningOf(ranges, whole), options, cloud);

    std::vector<LasRange> occupied;
    std::vector<std::uint64_t> places;
    std::uint64_t total = 0;
    for (std::size_t range = 0; range < ranges.size(); ++range) {
        if (counts[range] == 0) continue;
        occupied.push_back(ranges[range]);
        places.push_back(total);
        total += counts[range];
    }
    cloud.resize((total + every - 1) / every);
    std::vector<LasNotes> notes(occupied.size());
    source.read(occupied, [&](std::size_t range, std::uint64_t, std::span<const LasPoint> points) {
        for (const LasPoint& point : points) {
            if (!inBox(point)) continue;
            const std::uint64_t place = places[range]++;
            if (place % every != 0) continue;
            cloud.set(place / every, point);
            notes[range].add(point);
        }
    });
    return sumOf(notes);
}

Eigen::Vector3d wholeUnits(const Eigen::Vector3d& place) {
    return place.array().round().matrix();
}

/// Where the header says that the points are; where that makes no sense, the zero of their steps.
Eigen::Vector3d likelyOrigin(const LasHeader& header) {
    const Eigen::Vector3d middle = header.bounds.centre();
    return wholeUnits(middle.allFinite() ? middle : header.offset);
}

}  // namespace

PointCloud gatherLas(LasSource& source, std::span<const LasRange> ranges, const ReadOptions& options,
                     ReadJob& job) {
    const LasHeader& header = source.header();
    const auto gather = [&](LasCloud& cloud, bool exact) {
        return options.box ? gatherInside(source, ranges, options, cloud)
                           : gatherAll(source, ranges, options, cloud, exact);
    };
    LasNotes notes;
    {
        LasCloud cloud(header, options.attributes, likelyOrigin(header), false);
        notes = gather(cloud, false);
        if (cloud.holds(notes)) return std::move(cloud).build(notes, job);
    }
    // The header does not say where the points are, or they are spread so far that floats cannot tell them.
    const Eigen::Vector3d middle = 0.5 * (lasPosition(header, notes.least) + lasPosition(header, notes.most));
    LasCloud centred(header, options.attributes, wholeUnits(middle), false);
    const bool exact = !centred.holds(notes);
    LasCloud cloud(header, options.attributes, wholeUnits(middle), exact);
    notes = gather(cloud, exact);
    return std::move(cloud).build(notes, job);
}

}  // namespace vestige
