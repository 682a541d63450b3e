#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// Point clouds of SuperMap's S3M 3.0 and 3.01: the index *.scp with its tiles, or one *.s3mb. Written by the
/// published specification and not checked against SuperMap's own files, of which none is public.
class S3mbFormat : public FileFormat {
  public:
    std::string_view id() const override { return "s3mb"; }
    std::string_view title() const override { return "SuperMap S3M point cloud"; }
    std::vector<std::string> extensions() const override { return {"scp", "s3mb"}; }
    bool salvagesUnasked() const override { return true; }
    bool readsParts() const override { return true; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
