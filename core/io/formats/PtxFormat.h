#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// Leica's PTX: scans one after the other, each a grid of points in the scanner's frame and its transform.
/// The points are given in the file's frame, those without a return (0 0 0) left out.
class PtxFormat : public FileFormat {
  public:
    std::string_view id() const override { return "ptx"; }
    std::string_view title() const override { return "PTX scans"; }
    std::vector<std::string> extensions() const override { return {"ptx"}; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
