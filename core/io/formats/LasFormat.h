#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// LAS 1.0 to 1.4 with point formats 0 to 10, the same compressed as LAZ, and COPC, of which only the nodes
/// are read that a box or a preview needs; written as LAS 1.4.
class LasFormat : public FileFormat {
  public:
    std::string_view id() const override { return "las"; }
    std::string_view title() const override { return "LAS point cloud"; }
    std::vector<std::string> extensions() const override { return {"las", "laz"}; }
    bool canWrite() const override { return true; }
    bool readsParts() const override { return true; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> info(const std::filesystem::path& file, const JobControl& control) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<std::optional<LoadedGeometry>> preview(const std::filesystem::path& file, std::size_t points,
                                                  const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
    Status write(const std::filesystem::path& file, const TriangleMesh& geometry, const WriteOptions& options,
                 const JobControl& control) const override;
};

}  // namespace vestige
