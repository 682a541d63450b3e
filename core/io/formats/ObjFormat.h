#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

class ObjFormat : public FileFormat {
  public:
    std::string_view id() const override { return "obj"; }
    std::string_view title() const override { return "Wavefront OBJ mesh"; }
    std::vector<std::string> extensions() const override { return {"obj"}; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
