#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/base/JobControl.h"
#include "core/base/Result.h"

namespace vestige {

/// SHA-256 (FIPS 180-4) of bytes that come in pieces.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;

    void add(std::span<const std::byte> bytes);
    void add(const std::string& text);
    std::array<std::uint8_t, 32> digest();
    /// 64 lower-case hexadecimal digits.
    std::string hex();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// SHA-256 of a file's content, in lower-case hexadecimal.
Result<std::string> sha256OfFile(const std::filesystem::path& file, const JobControl& control = {});

}  // namespace vestige
