#pragma once

#include <array>
#include <cstdint>

#include "core/io/formats/laz/IntegerDecoder.h"
#include "core/io/formats/laz/MedianOfFive.h"
#include "core/io/formats/laz/Returns.h"

namespace vestige::laz {

/// What the first layer tells of a point beside x and y: what the other layers need.
struct PointChange {
    Returns returns;
    bool time = false;    ///< GPS time is another than that of the channel's last point
    bool source = false;  ///< and so is the point source
    unsigned sizeX = 0;   ///< bits of the corrections
    unsigned sizeY = 0;
};

/// The first layer as one scanner channel has it: channel, returns, x and y.
class PositionChannel {
  public:
    /// Begins a chunk, or a channel within one, behind a point with these values.
    void begin(std::uint32_t x, std::uint32_t y, Returns returns) {
        x_ = x;
        y_ = y;
        returns_ = returns;
        timeChanged_ = false;
        for (auto& model : changes_) model.restart();
        channel_.restart();
        for (auto& model : counts_) model.restart();
        for (auto& model : numbers_) model.restart();
        skip_.restart();
        dx_.restart();
        dy_.restart();
        medianX_.fill({});
        medianY_.fill({});
    }
    std::uint32_t x() const { return x_; }
    std::uint32_t y() const { return y_; }
    Returns returns() const { return returns_; }

    /// What changes: bits 0 and 1 the return number, 2 the number of returns, 3 scan angle, 4 GPS time, 5
    /// point source, 6 the channel.
    unsigned changes(RangeDecoder& code) {
        return code.symbol(changes_[returns_.place() + (timeChanged_ ? 4U : 0U)]);
    }
    /// By how many channels to go on, 1 to 3.
    unsigned channelStep(RangeDecoder& code) { return code.symbol(channel_) + 1; }

    [[gnu::always_inline]] PointChange next(RangeDecoder& coded, unsigned changes) {
        // A copy that nothing else refers to stays in registers.
        RangeDecoder code = coded;
        PointChange change;
        change.time = (changes & 16U) != 0;
        change.source = (changes & 32U) != 0;
        if ((changes & 7U) != 0) readReturns(code, changes);
        change.returns = returns_;
        timeChanged_ = change.time;
        const std::size_t context =
            2U * kReturnContexts[returns_.count][returns_.number] + (change.time ? 1U : 0U);
        const unsigned single = returns_.single();
        x_ += step(code, dx_, medianX_[context], single);
        change.sizeX = dx_.size();
        y_ += step(code, dy_, medianY_[context], single + (change.sizeX < 20 ? change.sizeX & ~1U : 20U));
        change.sizeY = dy_.size();
        coded = code;
        return change;
    }

  private:
    [[gnu::always_inline]] void readReturns(RangeDecoder& code, unsigned changes) {
        const unsigned before = returns_.number;
        if ((changes & 4U) != 0)
            returns_.count = static_cast<std::uint8_t>(code.symbol(counts_[returns_.count]));
        unsigned number = before;
        switch (changes & 3U) {
            case 1:
                number = before + 1;
                break;
            case 2:
                number = before + 15;
                break;
            case 3:
                number =
                    (changes & 16U) != 0 ? code.symbol(numbers_[before]) : before + code.symbol(skip_) + 2;
                break;
            default:
                break;
        }
        returns_.number = static_cast<std::uint8_t>(number % 16);
    }
    template <unsigned Contexts>
    [[gnu::always_inline]] static std::uint32_t step(RangeDecoder& code,
                                                     IntegerDecoder<32, Contexts>& decoder,
                                                     MedianOfFive& recent, unsigned context) {
        const std::uint32_t step = decoder.decode(code, static_cast<std::uint32_t>(recent.median()), context);
        recent.add(static_cast<std::int32_t>(step));
        return step;
    }

    std::uint32_t x_ = 0;
    std::uint32_t y_ = 0;
    Returns returns_;
    bool timeChanged_ = false;
    std::array<SymbolModel<128>, 8> changes_;
    SymbolModel<16> channel_{3};
    std::array<SymbolModel<16>, 16> counts_;
    std::array<SymbolModel<16>, 16> numbers_;
    SymbolModel<16> skip_{13};
    IntegerDecoder<32, 2> dx_;
    IntegerDecoder<32, 22> dy_;
    std::array<MedianOfFive, 12> medianX_;
    std::array<MedianOfFive, 12> medianY_;
};

/// The layer of heights as one scanner channel has it.
class HeightChannel {
  public:
    void begin(std::uint32_t z) {
        z_ = z;
        recent_.fill(z);
        decoder_.restart();
    }
    std::uint32_t z() const { return z_; }
    [[gnu::always_inline]] void next(RangeDecoder& code, const PointChange& change) {
        const unsigned size = (change.sizeX + change.sizeY) / 2;
        std::uint32_t& recent = recent_[change.returns.depth()];
        z_ = decoder_.decode(code, recent, change.returns.single() + (size < 18 ? size & ~1U : 18U));
        recent = z_;
    }

  private:
    std::uint32_t z_ = 0;
    std::array<std::uint32_t, 8> recent_{};
    IntegerDecoder<32, 20> decoder_;
};

}  // namespace vestige::laz
