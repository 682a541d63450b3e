#pragma once

#include <array>
#include <memory>
#include <span>

#include "core/io/formats/LasPoints.h"
#include "core/io/formats/laz/AttributeLayers.h"
#include "core/io/formats/laz/ColorLayer.h"
#include "core/io/formats/laz/TimeLayer.h"

namespace vestige::laz {

/// How the chunks of a file of point format 6, 7 or 8 are to be read.
struct ChunkLayout {
    std::size_t recordLength = 0;
    std::size_t layers = 0;
    bool colored = false;
    bool asVersion3 = false;  ///< see ColorLayer
    bool drawn = false;       ///< only position, intensity, colour, class and flags; else all of LasPoint
};

/// A chunk of points that LASzip packed in layers (item versions 3 and 4): a whole point, the number of
/// points, the size of each layer, the layers. Reads one chunk after the other; what is not asked for is not
/// unpacked and stays as in the chunk's first point.
class LayeredChunk {
  public:
    explicit LayeredChunk(const ChunkLayout& layout) : layout_(layout) {}

    /// The chunk that `bytes` begin with. False where they are too few for it.
    bool open(std::span<const std::byte> bytes);
    std::uint32_t points() const { return points_; }
    /// The next points, at most as many as are left. False where they are damaged.
    bool next(std::span<LasPoint> points);

  private:
    struct Layer {
        RangeDecoder code;
        bool coded = false;

        void begin(std::span<const std::byte> bytes) {
            coded = !bytes.empty();
            if (coded) code = RangeDecoder(bytes);
        }
        bool failed() const { return coded && code.failed(); }
    };
    struct Channel {
        PositionChannel position;
        HeightChannel height;
        IntensityChannel intensity;
        FlagChannel flags;
        ClassChannel classification;
        SourceChannel source;
        TimeChannel time;
    };

    void beginFirst(const std::byte* record);
    void changeChannel();
    void nextPoint(LasPoint& point);
    bool failed() const;

    ChunkLayout layout_;
    std::uint32_t points_ = 0;
    bool atFirst_ = true;
    unsigned current_ = 0;
    std::array<bool, 4> used_{};
    std::array<std::unique_ptr<Channel>, 4> channels_;
    RangeDecoder position_;
    Layer height_;
    Layer intensity_;
    Layer flags_;
    Layer classification_;
    Layer source_;
    Layer time_;
    ColorLayer color_;
    LasPoint first_;
};

}  // namespace vestige::laz
