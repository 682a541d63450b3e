#include <algorithm>

#include "core/base/Parallel.h"
#include "core/io/formats/LasSource.h"

namespace vestige {
namespace {

bool inside(const BoundingBox& box, const Eigen::Vector3d& place) {
    return (place.array() >= box.min.array()).all() && (place.array() <= box.max.array()).all();
}

LasNotes sumOf(std::span<const LasNotes> parts) {
    LasNotes sum;
    for (const LasNotes& part : parts) sum.add(part);
    return sum;
}

/// Every point's place is known before: threads fill the cloud directly.
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
    if (whole < total) cloud.resize((whole + every - 1) / every);
    return sumOf(notes);
}

/// Which points lie in the box is known only after they were read.
LasNotes gatherInside(LasSource& source, std::span<const LasRange> ranges, const ReadOptions& options,
                      LasCloud& cloud) {
    const std::uint64_t every = std::max<std::uint32_t>(1, options.keepEvery);
    std::vector<std::vector<std::pair<std::uint64_t, LasPoint>>> found(ranges.size());
    const std::uint64_t whole =
        source.read(ranges, [&](std::size_t range, std::uint64_t first, std::span<const LasPoint> points) {
            for (std::size_t i = 0; i < points.size(); ++i)
                if (inside(*options.box, lasPosition(source.header(), points[i].steps)))
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
    LasNotes notes;
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
    return notes;
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
