#pragma once

#include <cstddef>
#include <string>

#include "core/base/Error.h"
#include "core/io/ReadJob.h"

namespace vestige {

/// For FileInfo::damage of a file that was read up to `error`: where it is damaged, and how many points there
/// are before that.
std::string damageSentence(const ReadJob& job, const Error& error, std::size_t points);

}  // namespace vestige
