#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/JobControl.h"
#include "core/io/FileFormat.h"
#include "core/io/LoadEstimate.h"

namespace vestige::cli {

/// What of each input a command takes, where the whole does not fit or is not wanted.
struct FilePart {
    std::uint32_t every = 1;
    std::optional<BoundingBox> box;
    bool salvage = false;  ///< of a damaged file what is whole

    bool whole() const { return every <= 1 && !box; }
    ReadOptions options(ReadOptions::Attributes attributes) const;
};

/// Declares --salvage, --every, and --box of the input named; `part` must live as long as the command.
void addPartOptions(CLI::App& command, FilePart& part, const std::string& boxed = "the input");

/// Reads a part of a file, if there is memory for it and its use: else ErrorCode::input with what would fit.
Result<LoadedGeometry> readPart(const std::filesystem::path& file, const FilePart& part,
                                ReadOptions::Attributes attributes, LoadedFor use, const JobControl& control);

}  // namespace vestige::cli
