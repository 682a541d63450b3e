#include "core/io/formats/LasPoints.h"

#include <algorithm>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr std::size_t kBlock = 256;

/// Flags and classes, whose bits differ between the formats before and since 6 (LAS 1.4, tables 7 and 16).
void decodeFlags(const std::byte* record, bool extended, LasPoint& point) {
    const auto returns = load<std::uint8_t>(record + 14);
    if (extended) {
        point.returnNumber = returns & 15;
        point.returnCount = returns >> 4;
        point.withheld = (load<std::uint8_t>(record + 15) & 4) != 0;
        point.classification = load<std::uint8_t>(record + 16);
        point.pointSource = load<std::uint16_t>(record + 20);
    } else {
        point.returnNumber = returns & 7;
        point.returnCount = returns >> 3 & 7;
        const auto classification = load<std::uint8_t>(record + 15);
        point.withheld = (classification & 0x80) != 0;
        point.classification = classification & 31;
        point.pointSource = load<std::uint16_t>(record + 18);
    }
}

}  // namespace

void readLasPoints(std::span<const std::byte> file, const LasHeader& header, std::uint64_t begin,
                   std::uint64_t end, const LasBlockHandler& handle) {
    const LasPointLayout& layout = lasPointLayout(header.pointFormat);
    std::array<LasPoint, kBlock> block;
    const std::byte* record = file.data() + header.pointOffset + begin * header.recordLength;
    for (std::uint64_t first = begin; first < end; first += kBlock) {
        const auto many = static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, end - first));
        for (std::size_t i = 0; i < many; ++i, record += header.recordLength) {
            LasPoint& point = block[i];
            for (std::size_t axis = 0; axis < 3; ++axis)
                point.steps[axis] = load<std::int32_t>(record + 4 * axis);
            point.intensity = load<std::uint16_t>(record + 12);
            decodeFlags(record, layout.extended, point);
            if (layout.gpsTime) point.gpsTime = load<double>(record + layout.gpsTime);
            if (layout.color)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    point.color[channel] = load<std::uint16_t>(record + layout.color + 2 * channel);
        }
        handle(first, std::span(block).first(many));
    }
}

}  // namespace vestige
