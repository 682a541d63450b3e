#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// A smoothed trajectory (`*_sbet.out`, `.sbet`) as points in UTM of the first record's zone, with their GPS
/// time; heights stay what they are, above the ellipsoid.
class SbetFormat : public FileFormat {
  public:
    std::string_view id() const override { return "sbet"; }
    std::string_view title() const override { return "SBET trajectory"; }
    std::vector<std::string> extensions() const override { return {"sbet", "out"}; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
