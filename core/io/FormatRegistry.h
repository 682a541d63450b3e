#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/io/FileFormat.h"

namespace vestige {

/// Every format Vestige knows, in the order in which they are tried; readers, dialogs and docs go through
/// here.
const std::vector<std::unique_ptr<FileFormat>>& fileFormats();

/// The format that recognises the file's head, else by extension. ErrorCode::input names the file and what is
/// readable.
Result<const FileFormat*> formatOfFile(const std::filesystem::path& file);
/// The writing format of a path's extension. ErrorCode::usage lists what can be written.
Result<const FileFormat*> formatForWriting(const std::filesystem::path& file);

/// formatOfFile(...)->info / peek / preview / read, with every coordinate checked finite, and for `info` the
/// SHA-256.
Result<FileInfo> fileInfo(const std::filesystem::path& file, const JobControl& control = {});
Result<FileInfo> peekFile(const std::filesystem::path& file, const JobControl& control = {});
Result<std::optional<LoadedGeometry>> previewFile(const std::filesystem::path& file, std::size_t points,
                                                  const JobControl& control = {});
Result<LoadedGeometry> readGeometry(const std::filesystem::path& file, const ReadOptions& options,
                                    const JobControl& control = {});
inline Result<LoadedGeometry> readGeometry(const std::filesystem::path& file,
                                           const JobControl& control = {}) {
    return readGeometry(file, {}, control);
}
Status writeGeometry(const std::filesystem::path& file, const TriangleMesh& geometry,
                     const WriteOptions& options = {}, const JobControl& control = {});

}  // namespace vestige
