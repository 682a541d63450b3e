#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// The point cloud of a 3D Tiles tileset (1.0 and 1.1, explicit tiling): the point tiles that tileset.json
/// names, in the order of its tree, in its root's frame, in double.
class TilesetFormat : public FileFormat {
  public:
    std::string_view id() const override { return "tileset"; }
    std::string_view title() const override { return "3D Tiles tileset"; }
    std::vector<std::string> extensions() const override { return {"json"}; }
    bool salvagesUnasked() const override { return true; }
    bool readsParts() const override { return true; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
