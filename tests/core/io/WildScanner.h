#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/Random.h"
#include "core/io/Bytes.h"

namespace vestige::test {

/// Records of point format 7. What a scanner would not write all at once: every field changes, slowly, by
/// leaps, or not at all.
class WildScanner {
  public:
    explicit WildScanner(std::uint64_t seed, bool oneChannel = false)
        : random_(seed), oneChannel_(oneChannel) {}

    std::vector<std::byte> next() {
        if (random_.below(2000) == 0) calm_ = random_.below(7);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const unsigned bits = random_.below(calm_ == 0 ? 33 : 12);
            store<std::uint32_t>(at(4 * axis), load<std::uint32_t>(at(4 * axis)) + spread(bits));
        }
        if (may(3)) put<std::uint16_t>(12, 1 + calm_ * 9000);
        if (may(2)) put<std::uint8_t>(14, 256);
        std::uint8_t flags = load<std::uint8_t>(at(15));
        if (may(4)) flags = static_cast<std::uint8_t>(random_.below(256));
        if (oneChannel_) flags = static_cast<std::uint8_t>((flags & 0xcfU) | 16U);
        store<std::uint8_t>(at(15), flags);
        if (may(4)) put<std::uint8_t>(16, 256);
        if (may(5)) put<std::uint8_t>(17, 256);
        if (may(5)) put<std::int16_t>(18, 30000);
        if (may(6)) put<std::uint16_t>(20, 65536);
        time();
        for (std::size_t i = 0; i < 3; ++i)
            if (may(2)) put<std::uint16_t>(30 + 2 * i, calm_ % 2 == 0 ? 65536 : 256);
        if (may(5))
            for (std::size_t i = 1; i < 3; ++i) store(at(30 + 2 * i), load<std::uint16_t>(at(30)));
        return record_;
    }

  private:
    std::byte* at(std::size_t place) { return record_.data() + place; }
    bool may(unsigned rarity) { return random_.below(1 + rarity * calm_) == 0; }
    std::uint32_t spread(unsigned bits) {
        const std::uint64_t reach = std::uint64_t{1} << bits;
        return static_cast<std::uint32_t>(random_.below(reach)) - static_cast<std::uint32_t>(reach / 2);
    }
    template <class Number>
    void put(std::size_t place, std::uint64_t below) {
        store(at(place), static_cast<Number>(random_.below(below)));
    }
    /// Steady pulses, their multiples, several scanners by turns, leaps, and bits that are no time.
    void time() {
        const std::size_t clock = random_.below(calm_ < 3 ? 6 : 1);
        double& now = clocks_[clock];
        switch (random_.below(calm_ == 0 ? 12 : 5)) {
            case 0:
                break;
            case 1:
                now += 1e-5;
                break;
            case 2:
                now += 1e-5 * static_cast<double>(random_.below(600));
                break;
            case 3:
                now -= 1e-5 * static_cast<double>(random_.below(14));
                break;
            case 4:
                now += 1e-5 + 1e-9 * random_.uniform();
                break;
            case 5:
                now += 1000 * random_.uniform();
                break;
            case 6:
                store<std::uint64_t>(at(22), random_.below(~std::uint64_t{0}));
                return;
            default:
                break;
        }
        store(at(22), now);
    }

    Random random_;
    bool oneChannel_;
    unsigned calm_ = 1;
    std::array<double, 6> clocks_{1e8, 1e8 + 7, 2e8, 3.5, -4e5, 1.5e8};
    std::vector<std::byte> record_ = std::vector<std::byte>(36);
};

}  // namespace vestige::test
