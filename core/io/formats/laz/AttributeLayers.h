#pragma once

#include <array>
#include <cstdint>

#include "core/io/formats/laz/PositionLayers.h"

// The layers of attributes that are one small number, each as one scanner channel has it.
namespace vestige::laz {

class IntensityChannel {
  public:
    void begin(std::uint16_t intensity) {
        intensity_ = intensity;
        recent_.fill(intensity);
        decoder_.restart();
    }
    std::uint16_t intensity() const { return intensity_; }
    [[gnu::always_inline]] void next(RangeDecoder& code, const PointChange& change) {
        const unsigned place = change.returns.place();
        std::uint16_t& recent = recent_[2 * place + (change.time ? 1U : 0U)];
        intensity_ = static_cast<std::uint16_t>(decoder_.decode(code, recent, place));
        recent = intensity_;
    }

  private:
    std::uint16_t intensity_ = 0;
    std::array<std::uint16_t, 8> recent_{};
    IntegerDecoder<16, 4> decoder_;
};

class ClassChannel {
  public:
    void begin(std::uint8_t classification) {
        class_ = classification;
        for (auto& model : models_) model.restart();
    }
    std::uint8_t classification() const { return class_; }
    void next(RangeDecoder& code, const PointChange& change) {
        const unsigned single = change.returns.place() == 3 ? 1 : 0;
        class_ = static_cast<std::uint8_t>(code.symbol(models_[2U * (class_ & 31U) + single]));
    }

  private:
    std::uint8_t class_ = 0;
    std::array<SymbolModel<256>, 64> models_;
};

/// The four flags of the classification, scan direction (16) and edge of flight line (32).
class FlagChannel {
  public:
    void begin(std::uint8_t flags) {
        flags_ = flags & 63U;
        for (auto& model : models_) model.restart();
    }
    std::uint8_t flags() const { return flags_; }
    void next(RangeDecoder& code) { flags_ = static_cast<std::uint8_t>(code.symbol(models_[flags_])); }

  private:
    std::uint8_t flags_ = 0;
    std::array<SymbolModel<64>, 64> models_;
};

class SourceChannel {
  public:
    void begin(std::uint16_t source) {
        source_ = source;
        decoder_.restart();
    }
    std::uint16_t source() const { return source_; }
    void next(RangeDecoder& code) { source_ = static_cast<std::uint16_t>(decoder_.decode(code, source_, 0)); }

  private:
    std::uint16_t source_ = 0;
    IntegerDecoder<16, 1> decoder_;
};

}  // namespace vestige::laz
