#include "core/io/FormatRegistry.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>

#include "core/base/FileStamp.h"
#include "core/base/Hash.h"
#include "core/base/Parallel.h"
#include "core/io/ApplyReadOptions.h"
#include "core/io/CleanTexts.h"
#include "core/io/Coordinates.h"
#include "core/io/CrsUnits.h"
#include "core/io/InputHash.h"
#include "core/io/MappedFile.h"
#include "core/io/ReadJob.h"
#include "core/io/formats/E57Format.h"
#include "core/io/formats/EinscanMarkers.h"
#include "core/io/formats/GltfFormat.h"
#include "core/io/formats/LasFormat.h"
#include "core/io/formats/ObjFormat.h"
#include "core/io/formats/PcdFormat.h"
#include "core/io/formats/PlyFormat.h"
#include "core/io/formats/PntsFormat.h"
#include "core/io/formats/PtxFormat.h"
#include "core/io/formats/S3mbFormat.h"
#include "core/io/formats/SbetFormat.h"
#include "core/io/formats/StlFormat.h"
#include "core/io/formats/TextFormat.h"
#include "core/io/formats/ThreeMfFormat.h"
#include "core/io/formats/TilesetFormat.h"
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
        if (writable ? format->canWrite() : format->canRead())
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

Status unusable(const std::filesystem::path& file, const std::string& what) {
    return fail(ErrorCode::input, what + ": " + std::string(kUnusableCoordinate), file.string(),
                "expected: " + std::string(kUsableCoordinates));
}

Status checkCoordinates(const std::filesystem::path& file, const PointCloud& cloud) {
    // Where all are finite, those that reach farthest tell for all. Points on a grid are finite.
    constexpr std::size_t kGrain = 65536;
    const bool reachable = isUsable(cloud.bounds().min) && isUsable(cloud.bounds().max);
    if (reachable && cloud.grid()) return {};
    if (reachable && cloud.residuals().empty()) {
        std::vector<char> finite((cloud.size() + kGrain - 1) / kGrain, 0);
        parallelChunks(cloud.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
            const auto many = static_cast<Eigen::Index>(3 * (end - begin));
            const Eigen::Map<const Eigen::ArrayXf> all(cloud.offsets()[begin].data(), many);
            finite[chunk] = (0 * all).sum() == 0 ? 1 : 0;
        });
        if (std::count(finite.begin(), finite.end(), 0) == 0) return {};
    }
    std::vector<std::size_t> firsts((cloud.size() + kGrain - 1) / kGrain, cloud.size());
    parallelChunks(cloud.size(), kGrain, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && firsts[chunk] == cloud.size(); ++i)
            if (!isUsable(cloud.point(i))) firsts[chunk] = i;
    });
    for (const std::size_t first : firsts)
        if (first < cloud.size()) return unusable(file, "point " + std::to_string(first + 1));
    return {};
}

/// Of a file whose points were looked at and not kept.
Status checkBounds(const std::filesystem::path& file, const FileInfo& info) {
    if (info.points == 0 || (isUsable(info.bounds.min) && isUsable(info.bounds.max))) return {};
    return unusable(file, "the points' bounds");
}

/// For whoever shows it: texts that are clean, and a word on the unit.
void present(FileInfo& info) {
    tellUnits(info);
    cleanTexts(info);
}

template <class T>
Result<T> refused(Error error) {
    cleanTexts(error);
    return fail(std::move(error));
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

/// Indices of points have 32 bits.
constexpr std::size_t kMostPoints = 0xfffffff0;

/// Adds to a refusal what salvaging would give, for formats that find out only by doing it.
void offerWhatIsWhole(const FileFormat& format, const std::filesystem::path& file, const JobControl& control,
                      Error& error) {
    if (error.code != ErrorCode::input || error.salvageable || !format.salvagesUnasked()) return;
    ReadOptions salvage;
    salvage.attributes = ReadOptions::Attributes::drawn;
    salvage.salvage = true;
    const Result<LoadedGeometry> part = format.read(file, salvage, control);
    if (part && !part->geometry.vertices.empty())
        offerSalvage(error, counted(part->geometry.vertices.size(), "point"));
}

}  // namespace

const std::vector<std::unique_ptr<FileFormat>>& fileFormats() {
    // Never destroyed: a thread that looks into a file on a slow disk may outlast main().
    static const auto& formats = *new const std::vector<std::unique_ptr<FileFormat>>([] {
        std::vector<std::unique_ptr<FileFormat>> all;
        all.push_back(std::make_unique<LasFormat>());
        all.push_back(std::make_unique<E57Format>());
        all.push_back(std::make_unique<PlyFormat>());
        all.push_back(std::make_unique<PcdFormat>());
        all.push_back(std::make_unique<PntsFormat>());
        all.push_back(std::make_unique<TilesetFormat>());
        all.push_back(std::make_unique<S3mbFormat>());
        all.push_back(std::make_unique<VtkFormat>());
        all.push_back(std::make_unique<StlFormat>());
        all.push_back(std::make_unique<ObjFormat>());
        all.push_back(std::make_unique<GltfFormat>());
        all.push_back(std::make_unique<ThreeMfFormat>());
        all.push_back(std::make_unique<PtxFormat>());
        all.push_back(std::make_unique<SbetFormat>());
        all.push_back(std::make_unique<TextFormat>());
        all.push_back(std::make_unique<EinscanMarkers>());
        return all;
    }());
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
    if (!info) return refused<FileInfo>(info.error());
    if (const Status usable = checkBounds(file, *info); !usable) return fail(usable.error());
    present(*info);
    Result<InputHash> hash = hashInput(file, info->companions, control.sub(0.7, 1));
    if (!hash) return fail(hash.error());
    if (const Status same = companionsAsRead(*info); !same) return fail(same.error());
    info->sha256 = std::move(hash->sha256);
    return info;
}

Result<FileInfo> peekFile(const std::filesystem::path& file, const JobControl& control) {
    const Result<const FileFormat*> format = formatOfFile(file);
    if (!format) return fail(format.error());
    Result<FileInfo> info = (*format)->peek(file, control);
    if (!info) return refused<FileInfo>(info.error());
    if (!(*format)->readsParts()) info->heldToRead = info->points;
    present(*info);
    return info;
}

Result<std::optional<LoadedGeometry>> previewFile(const std::filesystem::path& file, std::size_t points,
                                                  const JobControl& control) {
    using Look = std::optional<LoadedGeometry>;
    return guarded(file.string(), [&]() -> Result<Look> {
        const Result<const FileFormat*> format = formatOfFile(file);
        if (!format) return fail(format.error());
        Result<Look> look =
            whileUnchanged<Look>(file, [&] { return (*format)->preview(file, points, control); });
        if (!look) return refused<Look>(look.error());
        if (!*look) return look;
        if (const Status usable = checkCoordinates(file, (*look)->geometry.vertices); !usable)
            return fail(usable.error());
        present((*look)->info);
        return look;
    });
}

Result<LoadedGeometry> readGeometry(const std::filesystem::path& file, const ReadOptions& options,
                                    const JobControl& control) {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<const FileFormat*> format = formatOfFile(file);
        if (!format) return fail(format.error());
        Result<LoadedGeometry> geometry =
            whileUnchanged<LoadedGeometry>(file, [&] { return (*format)->read(file, options, control); });
        if (!geometry) {
            Error error = geometry.error();
            if (!options.salvage) offerWhatIsWhole(**format, file, control, error);
            return refused<LoadedGeometry>(std::move(error));
        }
        if (geometry->geometry.vertices.size() > kMostPoints)
            return fail(ErrorCode::input, "the file holds more points than Vestige can number", file.string(),
                        "expected: at most " + std::to_string(kMostPoints) + "; load a part of it");
        applyReadOptions(options, *geometry);
        // Wherever warnings are read, the damage is read first.
        if (!geometry->info.damage.empty())
            geometry->info.warnings.insert(geometry->info.warnings.begin(), geometry->info.damage);
        if (const Status usable = checkCoordinates(file, geometry->geometry.vertices); !usable)
            return fail(usable.error());
        present(geometry->info);
        control.progress(1, "reading");
        return geometry;
    });
}

Status writeGeometry(const std::filesystem::path& file, const TriangleMesh& geometry,
                     const WriteOptions& options, const JobControl& control) {
    const Result<const FileFormat*> format = formatForWriting(file);
    if (!format) return fail(format.error());
    return (*format)->write(file, geometry, options, control);
}

}  // namespace vestige
