#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/core/io/Clouds.h"

namespace vestige::test {

/// Reads, or refuses with ErrorCode::input and a sentence that names the file.
inline void expectReadOrRefused(const std::filesystem::path& file) {
    const Result<LoadedGeometry> loaded = readGeometry(file);
    if (loaded) return;
    EXPECT_EQ(loaded.error().code, ErrorCode::input) << loaded.error().sentence();
    EXPECT_NE(loaded.error().place.find(file.string()), std::string::npos) << loaded.error().sentence();
    EXPECT_FALSE(loaded.error().message.empty());
}

/// Refuses with a sentence that names the file, holds `words` and says what was expected.
inline void expectRefusedWith(const std::filesystem::path& file, const std::string& content,
                              const std::string& words) {
    writeBytes(file, content);
    const Result<LoadedGeometry> loaded = readGeometry(file);
    ASSERT_FALSE(loaded) << words;
    EXPECT_EQ(loaded.error().code, ErrorCode::input);
    EXPECT_NE(loaded.error().place.find(file.string()), std::string::npos) << loaded.error().sentence();
    EXPECT_NE(loaded.error().message.find(words), std::string::npos) << loaded.error().sentence();
    EXPECT_NE(loaded.error().hint.find("expected: "), std::string::npos) << loaded.error().sentence();
}

}  // namespace vestige::test
