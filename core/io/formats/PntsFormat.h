#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// A single point tile of 3D Tiles 1.0. Its place in the world is in the tileset that names it
/// (TilesetFormat); alone it is read in its own frame, with RTC_CENTER.
class PntsFormat : public FileFormat {
  public:
    std::string_view id() const override { return "pnts"; }
    std::string_view title() const override { return "3D Tiles point tile"; }
    std::vector<std::string> extensions() const override { return {"pnts"}; }
    bool salvagesUnasked() const override { return true; }
    bool readsParts() const override { return true; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
