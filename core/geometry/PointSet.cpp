#include "core/geometry/PointSet.h"

#include <algorithm>
#include <iterator>

namespace vestige {
namespace {

/// Adds a run behind the others, joined to the last where they touch or overlap.
void append(std::vector<PointSet::Run>& runs, PointSet::Run run) {
    if (run.first >= run.second) return;
    if (!runs.empty() && runs.back().second >= run.first)
        runs.back().second = std::max(runs.back().second, run.second);
    else
        runs.push_back(run);
}

}  // namespace

PointSet PointSet::fromSorted(std::span<const std::uint32_t> indices) {
    std::vector<Run> runs;
    for (const std::uint32_t index : indices) append(runs, {index, index + 1});
    return fromRuns(std::move(runs));
}

PointSet PointSet::fromRuns(std::vector<Run> runs) {
    PointSet set;
    set.runs_ = std::move(runs);
    for (const auto& [first, last] : set.runs_) set.size_ += last - first;
    return set;
}

bool PointSet::contains(std::uint32_t index) const {
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), index,
                                        [](std::uint32_t i, const Run& run) { return i < run.first; });
    return after != runs_.begin() && index < std::prev(after)->second;
}

std::vector<std::uint32_t> PointSet::indices() const {
    std::vector<std::uint32_t> all;
    all.reserve(size_);
    for (const auto& [first, last] : runs_)
        for (std::uint32_t i = first; i < last; ++i) all.push_back(i);
    return all;
}

PointSet PointSet::unitedWith(const PointSet& other) const {
    std::vector<Run> sorted;
    sorted.reserve(runs_.size() + other.runs_.size());
    std::merge(runs_.begin(), runs_.end(), other.runs_.begin(), other.runs_.end(),
               std::back_inserter(sorted));
    std::vector<Run> runs;
    for (const Run& run : sorted) append(runs, run);
    return fromRuns(std::move(runs));
}

PointSet PointSet::without(const PointSet& other) const {
    std::vector<Run> left;
    auto cut = other.runs_.begin();
    for (auto [first, last] : runs_) {
        while (cut != other.runs_.end() && cut->second <= first) ++cut;
        for (auto at = cut; at != other.runs_.end() && at->first < last; ++at) {
            append(left, {first, std::min(at->first, last)});
            first = std::max(first, at->second);
        }
        append(left, {first, last});
    }
    return fromRuns(std::move(left));
}

PointSet PointSet::complement(std::uint32_t count) const {
    return fromRuns(count > 0 ? std::vector<Run>{{0, count}} : std::vector<Run>{}).without(*this);
}

}  // namespace vestige
