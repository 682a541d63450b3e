#include "core/io/FormatRegistry.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>

#include "core/base/FileStamp.h"
#include "core/base/Hash.h"
#include "core/io/ApplyReadOptions.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/LasFormat.h"
#include "core/io/formats/ObjFormat.h"
#include "core/io/formats/PcdFormat.h"
#include "core/io/formats/PlyFormat.h"
#include "core/io/formats/StlFormat.h"
#include "core/io/formats/TextFormat.h"
#include "core/io/formats/VtkFormat.h"

namespace vestige {
namespace {

std::string extensionOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::string listed(bool writable) {
    std::set<std::string> extensions;
    for (const auto& format : fileFormats())
        if (!writable || format->canWrite())
            for (const std::string& extension : format->extensions()) extensions.insert(extension);
    std::string text;
    for (const std::string& extension : extensions) text += (text.empty() ? "" : ", ") + extension;
    return text;
}

Result<std::vector<std::byte>> headOf(const std::filesystem::path& file) {
    std::error_code problem;
    if (std::filesystem::is_directory(file, problem))
        return fail(ErrorCode::input, "this is a folder, a file was expected", file.string());
    if (!std::filesystem::exists(file, problem))
        return fail(ErrorCode::input, "there is no such file", file.string());
    if (!std::filesystem::is_regular_file(file, problem))
        return fail(ErrorCode::input, "this is a device or pipe, a file was expected", file.string());
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return fail(ErrorCode::input, "the file cannot be opened for reading", file.string());
    std::vector<std::byte> head(4096);
    stream.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head;
}

Status checkFinite(const std::filesystem::path& file, const PointCloud& cloud) {
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (!cloud.point(i).allFinite())
            return fail(ErrorCode::input,
                        "point " + std::to_string(i + 1) + " has a coordinate that is no finite number",
                        file.string(), "finite coordinates");
    return {};
}

/// What `read` makes of the file, refused when the file is not the same before and after. Also where reading
/// failed: what it complains of may be what the change did.
template <class T, class Read>
Result<T> whileUnchanged(const std::filesystem::path& file, const Read& read) {
    const std::size_t faults = MappedFile::brokenReads();
    const auto before = stampOf(file);
    Result<T> result = read();
    if (!result && result.error().code == ErrorCode::cancelled) return result;
    if (const auto after = stampOf(file); before && (!after || *after != *before))
        return fail(changedWhileRead(file, *before));
    if (MappedFile::brokenReads() != faults)
        return fail(ErrorCode::input, "the disk could not read all of the file", file.string());
    return result;
}

}  // namespace

const std::vector<std::unique_ptr<FileFormat>>& fileFormats() {
    static const std::vector<std::unique_ptr<FileFormat>> formats = [] {
        std::vector<std::unique_ptr<FileFormat>> all;
        all.push_back(std::make_unique<LasFormat>());
        all.push_back(std::make_unique<PlyFormat>());
        all.push_back(std::make_unique<PcdFormat>());
        all.push_back(std::make_unique<VtkFormat>());
        all.push_back(std::make_unique<StlFormat>());
        all.push_back(std::make_unique<ObjFormat>());
        all.push_back(std::make_unique<TextFormat>());
        return all;
    }();
    return formats;
}

Result<const FileFormat*> formatOfFile(const std::filesystem::path& file) {
    const Result<std::vector<std::byte>> head = headOf(file);
    if (!head) return fail(head.error());
    if (head->empty())
        return fail(ErrorCode::input, "the file is empty", file.string() + ", byte 0",
                    "expected: a point cloud or a mesh");
    const std::string extension = extensionOf(file);
    for (const auto& format : fileFormats())
        if (format->recognises(*head, extension)) return format.get();
    for (const auto& format : fileFormats()) {
        const std::vector<std::string> extensions = format->extensions();
        if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            return format.get();
    }
    return fail(ErrorCode::input, "this is not a kind of file that Vestige reads", file.string() + ", byte 0",
                "readable: " + listed(false));
}

Result<const FileFormat*> formatForWriting(const std::filesystem::path& file) {
    const std::string extension = extensionOf(file);
    for (const auto& format : fileFormats()) {
        if (!format->canWrite()) continue;
        const std::vector<std::string> extensions = format->extensions();
        if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            return format.get();
    }
    return fail(ErrorCode::usage, "files with the extension '" + extension + "' cannot be written",
                file.string(), "writable: " + listed(true));
}

Result<FileInfo> fileInfo(const std::filesystem::path& file, const JobControl& control) {
    const Result<const FileFormat*> format = formatOfFile(file);
    if (!format) return fail(format.error());
    Result<FileInfo> info =
        whileUnchanged<FileInfo>(file, [&] { return (*format)->info(file, control.sub(0, 0.7)); });
    if (!info) return info;
    Result<std::string> hash = sha256OfFile(file, control.sub(0.7, 1));
    if (!hash) return fail(hash.error());
    info->sha256 = std::move(*hash);
    return info;
}

Result<FileInfo> peekFile(const std::filesystem::path& file, const JobControl& control) {
    const Result<const FileFormat*> format = formatOfFile(file);
    if (!format) return fail(format.error());
    return (*format)->peek(file, control);
}

Result<LoadedGeometry> readGeometry(const std::filesystem::path& file, const ReadOptions& options,
                                    const JobControl& control) {
    const Result<const FileFormat*> format = formatOfFile(file);
    if (!format) return fail(format.error());
    Result<LoadedGeometry> geometry =
        whileUnchanged<LoadedGeometry>(file, [&] { return (*format)->read(file, options, control); });
    if (!geometry) return geometry;
    applyReadOptions(options, *geometry);
    if (const Status finite = checkFinite(file, geometry->geometry.vertices); !finite)
        return fail(finite.error());
    control.progress(1, "reading");
    return geometry;
}

Status writeGeometry(const std::filesystem::path& file, const TriangleMesh& geometry,
                     const WriteOptions& options, const JobControl& control) {
    const Result<const FileFormat*> format = formatForWriting(file);
    if (!format) return fail(format.error());
    return (*format)->write(file, geometry, options, control);
}

}  // namespace vestige
