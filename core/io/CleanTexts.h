#pragma once

#include "core/base/Error.h"
#include "core/io/FileInfo.h"

namespace vestige {

/// The longest sentence, and the longest name, that a file may put before people, in bytes.
inline constexpr std::size_t kLongestSentence = 600;
inline constexpr std::size_t kLongestName = 200;

/// Makes what a file says of itself fit for terminals, tables and JSON (cleanText): what was in the file may
/// be in it word for word. Lines of a CRS become one; its records, which are written again, stay as they are.
void cleanTexts(FileInfo& info);
/// The same for a refusal; its place is a path, which stays.
void cleanTexts(Error& error);

}  // namespace vestige
