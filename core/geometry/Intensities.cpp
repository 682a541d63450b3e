#include "core/geometry/Intensities.h"

#include <algorithm>
#include <cmath>

#include "core/base/Parallel.h"

namespace vestige {
namespace {

constexpr std::size_t kGrain = 65536;

bool isWord(float value) {
    return value >= 0 && value <= 65535 && value == std::floor(value) && !std::signbit(value);
}

template <class Value>
LargeArray<Value> selected(const LargeArray<Value>& all, std::span<const std::uint32_t> indices) {
    LargeArray<Value> chosen;
    if (all.empty()) return chosen;
    chosen.resize(indices.size());
    parallelFor(indices.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) chosen[i] = all[indices[i]];
    });
    return chosen;
}

}  // namespace

Intensities::Intensities(std::initializer_list<float> values) {
    for (const float value : values) push_back(value);
}

Intensities::Intensities(const std::vector<float>& values) {
    reserve(values.size());
    for (const float value : values) push_back(value);
}

void Intensities::push_back(float value) {
    if (floats_.empty() && isWord(value)) {
        words_.push_back(static_cast<std::uint16_t>(value));
        return;
    }
    if (floats_.empty()) {
        floats_.reserve(std::max(words_.capacity(), words_.size() + 1));
        floats_.assign(words_.begin(), words_.end());
        words_ = {};
    }
    floats_.push_back(value);
}

Intensities Intensities::select(std::span<const std::uint32_t> indices) const {
    Intensities chosen;
    chosen.words_ = selected(words_, indices);
    chosen.floats_ = selected(floats_, indices);
    return chosen;
}

bool operator==(const Intensities& a, const Intensities& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace vestige
