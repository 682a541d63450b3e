#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

#include "core/base/LargeArray.h"

namespace vestige {

/// The intensities of a cloud's points: 2 bytes each while all are whole numbers up to 65535, as scanners
/// give them, else floats. Reads like a vector of floats.
class Intensities {
  public:
    using value_type = float;

    Intensities() = default;
    Intensities(std::initializer_list<float> values);
    Intensities(const std::vector<float>& values);
    explicit Intensities(LargeArray<std::uint16_t> words) : words_(std::move(words)) {}

    std::size_t size() const { return words_.size() + floats_.size(); }  // one of them is empty
    bool empty() const { return size() == 0; }
    float operator[](std::size_t i) const {
        return floats_.empty() ? static_cast<float>(words_[i]) : floats_[i];
    }

    void reserve(std::size_t count) { words_.reserve(count); }
    void push_back(float value);

    /// The intensities of the points `indices`, in their order.
    Intensities select(std::span<const std::uint32_t> indices) const;

    class Iterator {
      public:
        using iterator_category = std::input_iterator_tag;
        using value_type = float;
        using difference_type = std::ptrdiff_t;
        using pointer = const float*;
        using reference = float;

        Iterator(const Intensities& all, std::size_t place) : all_(&all), place_(place) {}
        float operator*() const { return (*all_)[place_]; }
        Iterator& operator++() {
            ++place_;
            return *this;
        }
        Iterator operator++(int) {
            const Iterator before = *this;
            ++place_;
            return before;
        }
        bool operator==(const Iterator&) const = default;

      private:
        const Intensities* all_;
        std::size_t place_;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size()}; }

    /// Equal values, whichever way they are held.
    friend bool operator==(const Intensities& a, const Intensities& b);

  private:
    LargeArray<std::uint16_t> words_;
    LargeArray<float> floats_;
};

}  // namespace vestige
