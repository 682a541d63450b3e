// One target per kind of geometry file, through the doors that the programs use; CMake names extension and
// format.
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "core/io/FormatRegistry.h"
#include "tests/fuzz/FuzzFile.h"
#include "tests/fuzz/MemoryBound.h"

using namespace vestige;

namespace {

// The packed formats set the pace: a byte of LZF may stand for 88, a point of three bytes is kept in 12 and
// more.
// What LASzip needs, and a short LAZ file may unpack to; other readers need next to nothing.
constexpr std::size_t kFixed = std::size_t{std::string_view(VESTIGE_FUZZ_FORMAT) == "las" ? 192 : 8} << 20;
constexpr std::size_t kPerByte = 1000;
constexpr double kFarthest = 1e10;

void checkInfo(const FileInfo& info) {
    for (const std::string& warning : info.warnings) fuzz::checkSentence(warning);
    if (!info.damage.empty()) fuzz::checkSentence(info.damage);
    if (!info.version.empty()) fuzz::checkSentence(info.version);
    if (info.warnings.size() > 1000) fuzz::finding("more warnings than anyone reads");
}

/// What was read is sound, whatever the file says.
void checkGeometry(const LoadedGeometry& loaded) {
    checkInfo(loaded.info);
    const PointCloud& cloud = loaded.geometry.vertices;
    const PointAttributes& attributes = cloud.attributes();
    for (const std::size_t count :
         {attributes.intensity.size(), attributes.color.size(), attributes.classification.size(),
          attributes.gpsTime.size(), attributes.normal.size(), attributes.pointSource.size(),
          attributes.returnNumber.size(), attributes.returnCount.size()})
        if (count != 0 && count != cloud.size())
            fuzz::finding("an attribute has another length than the cloud");
    for (std::size_t i = 0; i < cloud.size(); ++i)
        if (!(cloud.point(i).cwiseAbs().maxCoeff() <= 1.0001 * kFarthest))
            fuzz::finding("point " + std::to_string(i) + " is beyond any scan");
    for (const Triangle& triangle : loaded.geometry.triangles)
        for (const auto corner : triangle)
            if (corner >= cloud.size()) fuzz::finding("a triangle names a point that is not there");
}

std::optional<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options) {
    Result<LoadedGeometry> loaded = readGeometry(file, options);
    if (!loaded) {
        fuzz::checkError(loaded.error(), file);
        return std::nullopt;
    }
    checkGeometry(*loaded);
    return std::move(*loaded);
}

void readOtherwise(const std::filesystem::path& file, const std::optional<LoadedGeometry>& whole) {
    ReadOptions salvage;
    salvage.salvage = true;
    const std::optional<LoadedGeometry> salvaged = read(file, salvage);
    if (whole && (!salvaged || salvaged->geometry.vertices.size() != whole->geometry.vertices.size() ||
                  !salvaged->info.damage.empty()))
        fuzz::finding("a whole file is read otherwise where damage is allowed");
    if (!whole && salvaged && salvaged->info.damage.empty())
        fuzz::finding("a damaged file is read without a word of its damage");
    if (!whole || whole->geometry.vertices.empty()) return;
    const BoundingBox bounds = whole->geometry.vertices.bounds();
    ReadOptions part;
    part.box = BoundingBox{bounds.min, (bounds.min + bounds.max) / 2};
    part.keepEvery = 3;
    part.attributes = ReadOptions::Attributes::drawn;
    const std::optional<LoadedGeometry> some = read(file, part);
    if (!some) fuzz::finding("a part of a whole file is refused");
    if (some->geometry.vertices.size() > whole->geometry.vertices.size())
        fuzz::finding("a part has more points than the whole");
}

void describe(const std::filesystem::path& file) {
    if (const Result<FileInfo> info = fileInfo(file); info)
        checkInfo(*info);
    else
        fuzz::checkError(info.error(), file);
    if (const Result<FileInfo> peeked = peekFile(file); peeked)
        checkInfo(*peeked);
    else
        fuzz::checkError(peeked.error(), file);
    if (const auto preview = previewFile(file, 100); !preview)
        fuzz::checkError(preview.error(), file);
    else if (*preview)
        checkGeometry(**preview);
}

[[noreturn]] void cannotStart(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    bool found = false;
    for (const auto& format : fileFormats()) {
        const std::string id(format->id());
        if (!format->canRead()) continue;
        found = found || id == VESTIGE_FUZZ_FORMAT;
        if (std::string(VESTIGE_FUZZED_FORMATS).find(" " + id + " ") == std::string::npos)
            cannotStart("the format '" + id + "' has no line in tests/fuzz/CMakeLists.txt");
    }
    if (!found) cannotStart("no format has the id '" VESTIGE_FUZZ_FORMAT "'");
    ::unsetenv("VESTIGE_IMPORT");
    fuzz::MemoryBound::install();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::FuzzFile file(VESTIGE_FUZZ_NAME, VESTIGE_FUZZ_NAME);
    file.put({data, size});
    const fuzz::MemoryBound bound(size, kFixed, kPerByte);
    const Result<const FileFormat*> format = formatOfFile(file.path());
    if (!format) {
        fuzz::checkError(format.error(), file.path());
        return 0;
    }
    if ((*format)->id() != VESTIGE_FUZZ_FORMAT) return 0;
    const std::optional<LoadedGeometry> whole = read(file.path(), {});
    readOtherwise(file.path(), whole);
    describe(file.path());
    return 0;
}
