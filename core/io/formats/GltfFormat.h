#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// glTF 2.0, text (.gltf) and binary (.glb). Mesh data is read by vestige-import, the scene in double by us;
/// see core/io/importer/ImporterProcess.h and GltfScene.h.
class GltfFormat : public FileFormat {
  public:
    std::string_view id() const override { return "gltf"; }
    std::string_view title() const override { return "glTF scene"; }
    std::vector<std::string> extensions() const override { return {"glb", "gltf"}; }
    bool canWrite() const override { return true; }
    bool writesMetres() const override { return true; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
    Status write(const std::filesystem::path& file, const TriangleMesh& geometry, const WriteOptions& options,
                 const JobControl& control) const override;
};

}  // namespace vestige
