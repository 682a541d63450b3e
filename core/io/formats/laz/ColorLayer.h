#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/io/formats/laz/RangeDecoder.h"

namespace vestige::laz {

using Rgb = std::array<std::uint16_t, 3>;

/// The models of colours as one scanner channel has them: byte by byte, as differences to the last colour;
/// green and blue follow the change of red.
class ColorChannel {
  public:
    void restart() {
        changes_.restart();
        for (auto& model : bytes_) model.restart();
    }
    /// The colour behind `last`.
    [[gnu::always_inline]] Rgb next(RangeDecoder& code, const Rgb& last) {
        const unsigned changes = code.symbol(changes_);
        const int low0 = last[0] & 255;
        const int high0 = last[0] >> 8;
        const int low = (changes & 1U) != 0 ? read(code, 0, low0) : low0;
        const int high = (changes & 2U) != 0 ? read(code, 1, high0) : high0;
        const std::uint16_t red = joined(low, high);
        if ((changes & 64U) == 0) return {red, red, red};
        Rgb color{red, 0, 0};
        const Part lower = follow(code, changes, 2, low - low0, last[1] & 255, last[2] & 255);
        const Part upper = follow(code, changes, 3, high - high0, last[1] >> 8, last[2] >> 8);
        color[1] = joined(lower.green, upper.green);
        color[2] = joined(lower.blue, upper.blue);
        return color;
    }

  private:
    struct Part {
        int green;
        int blue;
    };

    static std::uint16_t joined(int low, int high) { return static_cast<std::uint16_t>(high << 8 | low); }
    [[gnu::always_inline]] int read(RangeDecoder& code, std::size_t model, int predicted) {
        return (static_cast<int>(code.symbol(bytes_[model])) + predicted) & 255;
    }
    /// The lower or upper bytes of green and blue where red's went by `step`; bit (and model) `bit` tells
    /// whether green is coded, that two further on whether blue is.
    [[gnu::always_inline]] Part follow(RangeDecoder& code, unsigned changes, unsigned bit, int step,
                                       int green, int blue) {
        Part part{green, blue};
        if ((changes >> bit & 1U) != 0) part.green = read(code, bit, std::clamp(step + green, 0, 255));
        if ((changes >> (bit + 2) & 1U) != 0) {
            const int both = (step + part.green - green) / 2;
            part.blue = read(code, bit + 2, std::clamp(both + blue, 0, 255));
        }
        return part;
    }

    SymbolModel<128> changes_;
    std::array<SymbolModel<256>, 6> bytes_;
};

/// The layer of colours. Files of LASzip's item version 3 choose channels as its first release did: a point
/// that stays in its channel is coded with the models of channel 0, and going to models that were used
/// before does not go to their last colour.
class ColorLayer {
  public:
    void begin(std::span<const std::byte> bytes, const Rgb& first, unsigned channel, bool asVersion3) {
        coded_ = !bytes.empty();
        if (coded_) code_ = RangeDecoder(bytes);
        asVersion3_ = asVersion3;
        used_ = {};
        last_[channel] = first;
        current_ = channel;
        open(channel);
    }
    bool failed() const { return coded_ && code_.failed(); }
    /// The next point's, which is in `channel`.
    [[gnu::always_inline]] const Rgb& next(unsigned channel, bool channelChanged) {
        if (!coded_) return last_[current_];
        const unsigned wanted = asVersion3_ && !channelChanged ? 0 : channel;
        unsigned place = current_;
        if (wanted != current_) [[unlikely]] {
            const bool fresh = !used_[wanted];
            if (fresh) {
                last_[wanted] = last_[current_];
                open(wanted);
            }
            if (fresh || !asVersion3_) place = wanted;
            current_ = wanted;
        }
        // A copy that nothing else refers to stays in registers.
        RangeDecoder code = code_;
        last_[place] = channels_[current_].next(code, last_[place]);
        code_ = code;
        return last_[place];
    }

  private:
    void open(unsigned channel) {
        used_[channel] = true;
        channels_[channel].restart();
    }

    RangeDecoder code_;
    bool coded_ = false;
    bool asVersion3_ = false;
    unsigned current_ = 0;  ///< the channel whose models are used
    std::array<bool, 4> used_{};
    std::array<Rgb, 4> last_{};
    std::array<ColorChannel, 4> channels_;
};

}  // namespace vestige::laz
