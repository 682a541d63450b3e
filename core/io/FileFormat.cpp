#include "core/io/FileFormat.h"

#include <utility>

namespace vestige {

Result<FileInfo> FileFormat::info(const std::filesystem::path& file, const JobControl& control) const {
    Result<LoadedGeometry> geometry = read(file, {}, control);
    if (!geometry) return fail(geometry.error());
    return std::move(geometry->info);
}

Result<FileInfo> FileFormat::peek(const std::filesystem::path& file, const JobControl&) const {
    FileInfo info;
    info.path = file;
    info.format = title();
    return info;
}

Result<std::optional<LoadedGeometry>> FileFormat::preview(const std::filesystem::path&, std::size_t,
                                                          const JobControl&) const {
    return std::nullopt;
}

Status FileFormat::write(const std::filesystem::path& file, const TriangleMesh&, const WriteOptions&,
                         const JobControl&) const {
    return fail(ErrorCode::usage, "the format " + std::string(id()) + " is read only", file.string());
}

}  // namespace vestige
