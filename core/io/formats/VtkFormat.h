#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

class VtkFormat : public FileFormat {
  public:
    std::string_view id() const override { return "vtk"; }
    std::string_view title() const override { return "VTK legacy point data"; }
    std::vector<std::string> extensions() const override { return {"vtk"}; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
