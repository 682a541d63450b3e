#include "core/io/formats/laz/LayeredChunk.h"

#include <bit>

namespace vestige::laz {
namespace {

constexpr std::size_t kColorAt = 30;  // of a record

/// In the order of the file.
enum LayerNumber { kPosition, kHeight, kClass, kFlags, kIntensity, kAngle, kUser, kSource, kTime, kColor };

}  // namespace

bool LayeredChunk::open(std::span<const std::byte> bytes) {
    const std::size_t head = layout_.recordLength + 4 + 4 * layout_.layers;
    if (bytes.size() < head) return false;
    points_ = load<std::uint32_t>(bytes.data() + layout_.recordLength);
    std::array<std::span<const std::byte>, kColor + 1> layers;
    std::span<const std::byte> rest = bytes.subspan(head);
    for (std::size_t layer = 0; layer < layout_.layers; ++layer) {
        const auto size = load<std::uint32_t>(bytes.data() + layout_.recordLength + 4 + 4 * layer);
        if (rest.size() < size) return false;
        if (layer < layers.size()) layers[layer] = rest.first(size);
        rest = rest.subspan(size);
    }
    if (points_ == 0) return false;
    position_ = RangeDecoder(layers[kPosition]);
    height_.begin(layers[kHeight]);
    intensity_.begin(layers[kIntensity]);
    flags_.begin(layers[kFlags]);
    classification_.begin(layers[kClass]);
    if (!layout_.drawn) {
        source_.begin(layers[kSource]);
        time_.begin(layers[kTime]);
    }
    beginFirst(bytes.data());
    if (layout_.colored) color_.begin(layers[kColor], first_.color, current_, layout_.asVersion3);
    return true;
}

void LayeredChunk::beginFirst(const std::byte* record) {
    used_ = {};
    current_ = load<std::uint8_t>(record + 15) >> 4 & 3U;
    used_[current_] = true;
    if (!channels_[current_]) channels_[current_] = std::make_unique_for_overwrite<Channel>();
    Channel& channel = *channels_[current_];
    const auto returns = load<std::uint8_t>(record + 14);
    const auto flags = load<std::uint8_t>(record + 15);
    channel.position.begin(
        load<std::uint32_t>(record), load<std::uint32_t>(record + 4),
        {static_cast<std::uint8_t>(returns & 15U), static_cast<std::uint8_t>(returns >> 4)});
    channel.height.begin(load<std::uint32_t>(record + 8));
    channel.intensity.begin(load<std::uint16_t>(record + 12));
    channel.flags.begin(static_cast<std::uint8_t>((flags & 15U) | (flags >> 2 & 48U)));
    channel.classification.begin(load<std::uint8_t>(record + 16));
    channel.source.begin(load<std::uint16_t>(record + 20));
    channel.time.begin(load<std::uint64_t>(record + 22));
    first_ = {};
    if (layout_.colored)
        for (std::size_t i = 0; i < 3; ++i) first_.color[i] = load<std::uint16_t>(record + kColorAt + 2 * i);
    atFirst_ = true;
}

/// To another channel, which begins as the one before is where it is met for the first time.
void LayeredChunk::changeChannel() {
    const Channel& before = *channels_[current_];
    current_ = (current_ + channels_[current_]->position.channelStep(position_)) % 4;
    if (used_[current_]) return;
    used_[current_] = true;
    if (!channels_[current_]) channels_[current_] = std::make_unique_for_overwrite<Channel>();
    Channel& channel = *channels_[current_];
    channel.position.begin(before.position.x(), before.position.y(), before.position.returns());
    channel.height.begin(before.height.z());
    channel.intensity.begin(before.intensity.intensity());
    channel.flags.begin(before.flags.flags());
    channel.classification.begin(before.classification.classification());
    channel.source.begin(before.source.source());
    channel.time.begin(before.time.time());
}

void LayeredChunk::nextPoint(LasPoint& point) {
    bool channelChanged = false;
    if (atFirst_) [[unlikely]] {
        atFirst_ = false;
        point.color = first_.color;
    } else {
        const unsigned changes = channels_[current_]->position.changes(position_);
        channelChanged = (changes & 64U) != 0;
        if (channelChanged) [[unlikely]]
            changeChannel();
        Channel& channel = *channels_[current_];
        const PointChange change = channel.position.next(position_, changes);
        if (height_.coded) channel.height.next(height_.code, change);
        if (intensity_.coded) channel.intensity.next(intensity_.code, change);
        if (flags_.coded) channel.flags.next(flags_.code);
        if (classification_.coded) channel.classification.next(classification_.code, change);
        if (source_.coded && change.source) channel.source.next(source_.code);
        if (time_.coded && change.time) channel.time.next(time_.code);
        if (layout_.colored) point.color = color_.next(current_, channelChanged);
    }
    const Channel& channel = *channels_[current_];
    point.steps = {static_cast<std::int32_t>(channel.position.x()),
                   static_cast<std::int32_t>(channel.position.y()),
                   static_cast<std::int32_t>(channel.height.z())};
    point.intensity = channel.intensity.intensity();
    point.returnNumber = channel.position.returns().number;
    point.returnCount = channel.position.returns().count;
    point.classification = channel.classification.classification();
    point.withheld = (channel.flags.flags() & 4U) != 0;
    point.pointSource = channel.source.source();
    point.gpsTime = std::bit_cast<double>(channel.time.time());
}

bool LayeredChunk::next(std::span<LasPoint> points) {
    for (LasPoint& point : points) nextPoint(point);
    return !failed();
}

bool LayeredChunk::failed() const {
    return (points_ > 1 && position_.failed()) || height_.failed() || intensity_.failed() ||
           flags_.failed() || classification_.failed() || source_.failed() || time_.failed() ||
           (layout_.colored && color_.failed());
}

}  // namespace vestige::laz
