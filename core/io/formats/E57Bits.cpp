#include "core/io/formats/E57Bits.h"

#include <utility>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

constexpr unsigned kBitsOfOneLoad = 57;  // any seven bits before them included

double realOf(const E57Field& field, std::uint64_t raw) {
    // Unsigned, so that a sum beyond the type wraps as two's complement does.
    const auto number = static_cast<std::int64_t>(raw + static_cast<std::uint64_t>(field.minimum));
    return field.offset + field.scale * static_cast<double>(number);
}

void decodeIntegers(const E57Field& field, const std::byte* bytes, unsigned skip, std::span<double> values) {
    const unsigned bits = field.bits;
    const std::uint64_t mask = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    std::uint64_t position = skip;
    for (double& value : values) {
        const std::byte* at = bytes + position / 8;
        const unsigned shift = position % 8;
        std::uint64_t raw = load<std::uint64_t>(at) >> shift;
        if (bits > kBitsOfOneLoad && shift > 0) raw |= static_cast<std::uint64_t>(at[8]) << (64 - shift);
        value = realOf(field, raw & mask);
        position += bits;
    }
}

}  // namespace

void decodeE57(const E57Field& field, const std::byte* bytes, unsigned skip, std::span<double> values) {
    switch (field.type) {
        case E57Field::Type::float32:
            for (std::size_t i = 0; i < values.size(); ++i) values[i] = load<float>(bytes + 4 * i);
            return;
        case E57Field::Type::float64:
            for (std::size_t i = 0; i < values.size(); ++i) values[i] = load<double>(bytes + 8 * i);
            return;
        case E57Field::Type::integer:
            decodeIntegers(field, bytes, skip, values);
            return;
        case E57Field::Type::text:
            return;
    }
}

void E57BitWriter::put(std::uint64_t value, unsigned bits) {
    for (unsigned done = 0; done < bits;) {
        const unsigned piece = std::min(bits - done, 64 - used_);
        const std::uint64_t mask = piece == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << piece) - 1;
        pending_ |= (value >> done & mask) << used_;
        used_ += piece;
        done += piece;
        if (used_ < 64) continue;
        bytes_.resize(bytes_.size() + 8);
        store(bytes_.data() + bytes_.size() - 8, pending_);
        pending_ = 0;
        used_ = 0;
    }
}

std::vector<std::byte> E57BitWriter::take(bool last) {
    for (; used_ >= 8 || (last && used_ > 0); used_ -= std::min(used_, 8U)) {
        bytes_.push_back(static_cast<std::byte>(pending_ & 0xff));
        pending_ >>= 8;
    }
    return std::exchange(bytes_, {});
}

}  // namespace vestige
