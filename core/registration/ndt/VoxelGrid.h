#pragma once

#include <cmath>
#include <cstdint>

namespace vestige {

/// Cubes of edge `size` in a registration's own frame, a corner of them at -`shift` on every axis. 21 bits an
/// axis: coordinates up to a million cells from the origin.
class VoxelGrid {
  public:
    static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};
    static constexpr std::int64_t kMask = (std::int64_t{1} << 21) - 1;
    static constexpr std::int64_t kHalf = std::int64_t{1} << 20;

    explicit VoxelGrid(double size, double shift = 0) : size_(size), perMetre_(1 / size), shift_(shift) {}

    double size() const { return size_; }
    double perMetre() const { return perMetre_; }
    double shift() const { return shift_; }
    /// Key of the cell that holds the point; kNoKey outside the grid.
    std::uint64_t key(double x, double y, double z) const {
        const std::int64_t i = index(x);
        const std::int64_t j = index(y);
        const std::int64_t k = index(z);
        if (((i | j | k) & ~kMask) != 0) return kNoKey;
        return pack(i, j, k);
    }
    /// The key `dx, dy, dz` cells further; kNoKey where `key` is, or beyond the border.
    static std::uint64_t neighbour(std::uint64_t key, int dx, int dy, int dz) {
        if (key == kNoKey) return kNoKey;
        const std::int64_t i = static_cast<std::int64_t>(key & kMask) + dx;
        const std::int64_t j = static_cast<std::int64_t>(key >> 21 & kMask) + dy;
        const std::int64_t k = static_cast<std::int64_t>(key >> 42 & kMask) + dz;
        if (((i | j | k) & ~kMask) != 0) return kNoKey;
        return pack(i, j, k);
    }
    /// The key of the block of 2^bits cells an axis that holds the cell, in a grid of such blocks.
    static std::uint64_t block(std::uint64_t key, int bits) {
        const std::uint64_t axis = static_cast<std::uint64_t>(kMask) >> bits;
        const std::uint64_t kept = axis | axis << 21 | axis << 42;
        return key >> bits & kept;
    }
    /// The key, in a grid of twice the size and without shift, of the cell that holds this one.
    static std::uint64_t parent(std::uint64_t key) {
        constexpr std::uint64_t kOrigin = kHalf / 2;
        return block(key, 1) + (kOrigin | kOrigin << 21 | kOrigin << 42);
    }
    double centreX(std::uint64_t key) const { return centre(key & kMask); }
    double centreY(std::uint64_t key) const { return centre(key >> 21 & kMask); }
    double centreZ(std::uint64_t key) const { return centre(key >> 42 & kMask); }

    /// Full avalanche in 32-bit steps, so that eight keys can be hashed at once (NdtKernel.cpp does): weaker
    /// mixes of packed keys cluster under linear probing. (Finisher: Ellis, "prospecting for hash
    /// functions".)
    static std::uint32_t hash(std::uint64_t key) {
        std::uint32_t h =
            static_cast<std::uint32_t>(key) * kHashLow + static_cast<std::uint32_t>(key >> 32) * kHashHigh;
        h = (h ^ (h >> 16)) * kHashFirst;
        h = (h ^ (h >> 15)) * kHashSecond;
        return h ^ (h >> 16);
    }
    static constexpr std::uint32_t kHashLow = 0x9e3779b1, kHashHigh = 0x85ebca77, kHashFirst = 0x7feb352d,
                                   kHashSecond = 0x846ca68b;

  private:
    std::int64_t index(double x) const {
        return static_cast<std::int64_t>(std::floor((x + shift_) * perMetre_)) + kHalf;
    }
    double centre(std::uint64_t index) const {
        return (static_cast<double>(static_cast<std::int64_t>(index) - kHalf) + 0.5) * size_ - shift_;
    }
    static std::uint64_t pack(std::int64_t i, std::int64_t j, std::int64_t k) {
        return static_cast<std::uint64_t>(i) | static_cast<std::uint64_t>(j) << 21 |
               static_cast<std::uint64_t>(k) << 42;
    }

    double size_;
    double perMetre_;
    double shift_;
};

}  // namespace vestige
