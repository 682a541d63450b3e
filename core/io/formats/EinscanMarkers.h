#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// EXScan's global marker file (.p3). Its layout is not public, so it is known by its extension alone and
/// refused with advice what to export instead.
class EinscanMarkers : public FileFormat {
  public:
    std::string_view id() const override { return "p3"; }
    std::string_view title() const override { return "EinScan marker file"; }
    std::vector<std::string> extensions() const override { return {"p3"}; }
    bool canRead() const override { return false; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
