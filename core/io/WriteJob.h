#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "core/base/AtomicFile.h"
#include "core/base/JobControl.h"
#include "core/io/PointColumns.h"

namespace vestige {

/// Opens `file`, lets `body` write to it and puts it in place; an exception of the body, a cancel or a full
/// disk leaves what stood there before. Every error is ErrorCode::output, except a cancel.
Status writeAtomically(const std::filesystem::path& file, const std::function<void(AtomicFile&)>& body);

/// Throws ErrorException when cancelled; cheap enough for every item.
void stepWriting(const JobControl& control, std::size_t done, std::size_t total);

/// The columns' values, point after point, packed little endian.
void writeRecords(AtomicFile& file, std::span<const PointColumn> columns, std::size_t points,
                  const JobControl& control);

}  // namespace vestige
