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

void decodeLasRecords(const std::byte* records, std::size_t count, const LasHeader& header,
                      std::uint64_t first, const LasBlockHandler& handle) {
    const LasPointLayout& layout = lasPointLayout(header.pointFormat);
    std::array<LasPoint, kBlock> block;
    for (std::size_t done = 0; done < count; done += kBlock) {
        const std::size_t many = std::min(kBlock, count - done);
        for (std::size_t i = 0; i < many; ++i, records += header.recordLength) {
            LasPoint& point = block[i];
            for (std::size_t axis = 0; axis < 3; ++axis)
                point.steps[axis] = load<std::int32_t>(records + 4 * axis);
            point.intensity = load<std::uint16_t>(records + 12);
            decodeFlags(records, layout.extended, point);
            if (layout.gpsTime) point.gpsTime = load<double>(records + layout.gpsTime);
            if (layout.color)
                for (std::size_t channel = 0; channel < 3; ++channel)
                    point.color[channel] = load<std::uint16_t>(records + layout.color + 2 * channel);
        }
        handle(first + done, std::span(block).first(many));
    }
}

void LasNotes::add(const LasPoint& point) {
    LasNotes one{1, point.withheld ? 1U : 0U, std::max({point.color[0], point.color[1], point.color[2]}),
                 point.steps, point.steps};
    add(one);
}

void LasNotes::add(const LasNotes& other) {
    if (other.points == 0) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        least[axis] = points == 0 ? other.least[axis] : std::min(least[axis], other.least[axis]);
        most[axis] = points == 0 ? other.most[axis] : std::max(most[axis], other.most[axis]);
    }
    points += other.points;
    withheld += other.withheld;
    brightest = std::max(brightest, other.brightest);
}

}  // namespace vestige
