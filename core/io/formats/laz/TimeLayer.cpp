#include "core/io/formats/laz/TimeLayer.h"

namespace vestige::laz {
namespace {

constexpr unsigned kMostMultiple = 500;
constexpr unsigned kMostNegative = 10;
constexpr unsigned kWhole = kMostMultiple + kMostNegative + 1;
constexpr int kExtremesInARow = 3;
/// An encoder goes to another sequence at most once for a time; damaged bytes could do so for long.
constexpr int kMostSwitches = 64;

std::uint64_t extended(std::uint32_t number) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(static_cast<std::int32_t>(number)));
}

}  // namespace

void TimeChannel::begin(std::uint64_t time) {
    time_ = time;
    sequences_.fill({});
    sequences_[0].time = time;
    current_ = 0;
    newest_ = 0;
    multiples_.restart();
    firsts_.restart();
    decoder_.restart();
}

void TimeChannel::next(RangeDecoder& code) {
    bool read = false;
    for (int i = 0; !read && i < kMostSwitches; ++i)
        read = sequences_[current_].difference == 0 ? readAfterNone(code) : readAfterDifference(code);
    if (!read) code.fail();
    time_ = sequences_[current_].time;
}

bool TimeChannel::readAfterNone(RangeDecoder& code) {
    const unsigned symbol = code.symbol(firsts_);
    Sequence& sequence = sequences_[current_];
    if (symbol == 0) {
        sequence.difference = decoder_.decode(code, 0, 0);
        sequence.time += extended(sequence.difference);
        sequence.extremes = 0;
    } else if (symbol == 1) {
        readWhole(code);
    } else {
        current_ = (current_ + symbol - 1) % 4;
        return false;
    }
    return true;
}

bool TimeChannel::readAfterDifference(RangeDecoder& code) {
    const unsigned symbol = code.symbol(multiples_);
    Sequence& sequence = sequences_[current_];
    const std::uint32_t last = sequence.difference;
    if (symbol == 0) {
        addDifference(decoder_.decode(code, 0, 7), true);
    } else if (symbol == 1) {
        sequence.time += extended(decoder_.decode(code, last, 1));
        sequence.extremes = 0;
    } else if (symbol < kMostMultiple) {
        addDifference(decoder_.decode(code, symbol * last, symbol < 10 ? 2 : 3), false);
    } else if (symbol == kMostMultiple) {
        addDifference(decoder_.decode(code, symbol * last, 4), true);
    } else if (symbol < kWhole) {
        const unsigned negative = symbol - kMostMultiple;
        const bool most = negative == kMostNegative;
        addDifference(decoder_.decode(code, 0U - negative * last, most ? 6 : 5), most);
    } else if (symbol == kWhole) {
        readWhole(code);
    } else {
        current_ = (current_ + symbol - kWhole) % 4;
        return false;
    }
    return true;
}

void TimeChannel::readWhole(RangeDecoder& code) {
    const auto predicted = static_cast<std::uint32_t>(sequences_[current_].time >> 32);
    const std::uint64_t upper = decoder_.decode(code, predicted, 8);
    const std::uint32_t lower = code.bits(32);
    newest_ = (newest_ + 1) % 4;
    current_ = newest_;
    sequences_[current_] = {upper << 32 | lower};
}

void TimeChannel::addDifference(std::uint32_t difference, bool extreme) {
    Sequence& sequence = sequences_[current_];
    sequence.time += extended(difference);
    if (extreme && ++sequence.extremes > kExtremesInARow) {
        sequence.difference = difference;
        sequence.extremes = 0;
    }
}

}  // namespace vestige::laz
