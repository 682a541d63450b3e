#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

class StlFormat : public FileFormat {
  public:
    std::string_view id() const override { return "stl"; }
    std::string_view title() const override { return "STL mesh"; }
    std::vector<std::string> extensions() const override { return {"stl"}; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
