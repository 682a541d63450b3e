#pragma once

#include "core/io/FileFormat.h"

namespace vestige {

/// 3D Manufacturing Format: a zip archive with meshes in XML. Read by vestige-import, see
/// core/io/importer/ImporterProcess.h.
class ThreeMfFormat : public FileFormat {
  public:
    std::string_view id() const override { return "3mf"; }
    std::string_view title() const override { return "3MF mesh"; }
    std::vector<std::string> extensions() const override { return {"3mf"}; }
    bool recognises(std::span<const std::byte> head, std::string_view extension) const override;
    Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                const JobControl& control) const override;
};

}  // namespace vestige
