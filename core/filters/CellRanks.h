#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace vestige {

/// The occupied cells of one bucket after another, as bits of a map: a cell's rank among them is both its
/// place in ascending order and where its sums are kept. A second map of the words that are not empty makes
/// a bucket cost what it holds, not its volume.
class CellRanks {
  public:
    explicit CellRanks(unsigned keyBits)
        : words_(wordsFor(keyBits), 0), before_(words_.size()), occupied_((words_.size() + 63) / 64, 0) {}

    void mark(std::uint32_t key) {
        const std::uint32_t word = key >> 6;
        words_[word] |= std::uint64_t{1} << (key & 63);
        occupied_[word >> 6] |= std::uint64_t{1} << (word & 63);
    }
    /// After all marks: the number of cells marked.
    std::uint32_t count() {
        std::uint32_t cells = 0;
        eachWord([&](std::uint32_t word) {
            before_[word] = cells;
            cells += static_cast<std::uint32_t>(std::popcount(words_[word]));
        });
        return cells;
    }
    /// Of a marked cell, after count().
    std::uint32_t rank(std::uint32_t key) const {
        const std::uint64_t below = words_[key >> 6] & ((std::uint64_t{1} << (key & 63)) - 1);
        return before_[key >> 6] + static_cast<std::uint32_t>(std::popcount(below));
    }
    /// use(key) in the order of rank; nothing is marked afterwards.
    template <class Use>
    void takeKeys(const Use& use) {
        eachWord([&](std::uint32_t word) {
            for (std::uint64_t bits = words_[word]; bits != 0; bits &= bits - 1)
                use(word << 6 | static_cast<std::uint32_t>(std::countr_zero(bits)));
            words_[word] = 0;
        });
        std::fill(occupied_.begin(), occupied_.end(), 0);
    }

  private:
    static std::size_t wordsFor(unsigned keyBits) {
        return keyBits > 6 ? std::size_t{1} << (keyBits - 6) : 1;
    }

    template <class Use>
    void eachWord(const Use& use) {
        for (std::size_t group = 0; group < occupied_.size(); ++group)
            for (std::uint64_t bits = occupied_[group]; bits != 0; bits &= bits - 1)
                use(static_cast<std::uint32_t>(group << 6 |
                                               static_cast<std::size_t>(std::countr_zero(bits))));
    }

    std::vector<std::uint64_t> words_;
    std::vector<std::uint32_t> before_;
    std::vector<std::uint64_t> occupied_;
};

}  // namespace vestige
