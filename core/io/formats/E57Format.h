#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

class E57Format : public FileFormat {
  public:
    std::string_view id() const override { return "e57"; }
    std::string_view title() const override { return "E57 laser scans"; }
    std::vector<std::string> extensions() const override { return {"e57"}; }
    bool canWrite() const override { return true; }
    bool writesMetres() const override { return true; }
    bool salvagesUnasked() const override { return true; }
    bool readsParts() const override { return true; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<std::optional<LoadedGeometry>> preview(const std::filesystem::path& file, std::size_t points,
                                                  const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
    Status write(const std::filesystem::path& file, const TriangleMesh& geometry, const WriteOptions& options,
                 const JobControl& control) const override;
};

}  // namespace vestige
