#include "core/geometry/Intensities.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/Selected.h"

namespace vestige {
namespace {

bool isWord(float value) {
    return value >= 0 && value <= 65535 && value == std::floor(value) && !std::signbit(value);
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
