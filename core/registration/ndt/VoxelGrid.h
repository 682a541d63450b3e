#pragma once

#include <cmath>
#include <cstdint>

namespace vestige {

/// Cubes of edge `size` in a registration's own frame, a corner of them at -`shift` on every axis. 21 bits an
/// axis: coordinates up to a million cells from the origin.
class VoxelGrid {
  public:
    static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

    explicit VoxelGrid(double size, double shift = 0) : size_(size), perMetre_(1 / size), shift_(shift) {}

    double size() const { return size_; }
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
    double centreX(std::uint64_t key) const { return centre(key & kMask); }
    double centreY(std::uint64_t key) const { return centre(key >> 21 & kMask); }
    double centreZ(std::uint64_t key) const { return centre(key >> 42 & kMask); }

    /// Full avalanche (SplitMix64's finisher): weaker mixes of packed keys cluster under linear probing.
    static std::uint64_t hash(std::uint64_t key) {
        key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9ULL;
        key = (key ^ (key >> 27)) * 0x94d049bb133111ebULL;
        return key ^ (key >> 31);
    }

  private:
    static constexpr std::int64_t kMask = (std::int64_t{1} << 21) - 1;
    static constexpr std::int64_t kHalf = std::int64_t{1} << 20;

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
