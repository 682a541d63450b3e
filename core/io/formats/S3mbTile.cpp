#include "core/io/formats/S3mbTile.h"

#include <Eigen/LU>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/io/formats/S3mbSkeleton.h"
#include "core/io/formats/S3mbStream.h"
#include "core/io/formats/Unpack.h"

namespace vestige {
namespace {

constexpr std::size_t kHeaderBytes = 16;
constexpr std::size_t kLargestTile = std::size_t{1} << 30;
enum Packing : std::uint32_t { kNone = 0, kZip = 1, kGzip = 2 };
constexpr std::size_t kVolumeBytes = (4 + 12) * sizeof(double);  // a sphere and a box

double versionOf(std::span<const std::byte> file, const ReadJob& job) {
    if (file.size() < kHeaderBytes)
        refuseS3mb(job, "the file ends inside the header of the S3MB tile", counted(kHeaderBytes, "byte"));
    const double version = load<float>(file.data());
    if (!(std::abs(version - 3) < 0.001 || std::abs(version - 3.01) < 0.001))
        refuseS3mb(job,
                   std::isfinite(version) && version > 0 && version < 100
                       ? "the S3MB tile has version " + fixedText(version, 2)
                       : "this is no S3MB tile",
                   "version 3.0 or 3.01");
    return version;
}

std::vector<std::byte> unpacked(std::span<const std::byte> file, const ReadJob& job) {
    const auto word = [&](std::size_t at) { return load<std::uint32_t>(file.data() + at); };
    const std::size_t size = word(8);
    const std::size_t packed = word(12);
    if (packed > file.size() - kHeaderBytes)
        job.refuseByte(file.size(), "the file ends inside the S3MB tile",
                       counted(kHeaderBytes + packed, "byte"));
    const auto package = file.subspan(kHeaderBytes, packed);
    switch (word(4)) {
        case kNone:
            return {package.begin(), package.end()};
        case kZip:
        case kGzip:
            return inflated(package, size, kLargestTile, kHeaderBytes, job);
        default:
            refuseS3mb(job, "the S3MB tile is packed in the way " + std::to_string(word(4)),
                       "0 (not), 1 (zip) or 2 (gzip)");
    }
}

/// Sixteen numbers whose last four are the translation: rows, for row vectors (as the published SDK uses
/// them).
Eigen::Matrix4d takeMatrix(S3mbStream& stream) {
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i) matrix(i % 4, i / 4) = stream.take<double>();
    if (!matrix.allFinite() || matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1) ||
        matrix.topLeftCorner<3, 3>().determinant() == 0)
        stream.refuse("the matrix of a patch is not affine and invertible",
                      "a translation in the last four numbers");
    return matrix;
}

std::vector<S3mbLod> takeLods(S3mbStream stream) {
    std::vector<S3mbLod> lods;
    const std::size_t count = stream.takeCount(6 + kVolumeBytes + 12);
    for (std::size_t i = 0; i < count; ++i) {
        S3mbLod& lod = lods.emplace_back();
        stream.skip(6 + kVolumeBytes);  // range, its mode, sphere and box
        lod.child = stream.takeString();
        const std::size_t patches = stream.takeCount(16 * sizeof(double) + 4);
        for (std::size_t p = 0; p < patches; ++p) {
            S3mbPatch& patch = lod.patches.emplace_back();
            patch.tilesFromPatch = takeMatrix(stream);
            const std::size_t names = stream.takeCount(4);
            for (std::size_t n = 0; n < names; ++n) patch.skeletons.push_back(stream.takeString());
        }
        stream.takeString();  // animations
    }
    return lods;
}

}  // namespace

S3mbTile parseS3mbTile(std::span<const std::byte> file, ReadJob& job) {
    S3mbTile tile;
    const double version = versionOf(file, job);
    tile.version = fixedText(version, version < 3.005 ? 1 : 2);
    tile.bytes = unpacked(file, job);
    S3mbStream stream(tile.bytes, "the tile", job);
    stream.skip(4);
    tile.lods = takeLods(stream.takeStream("the levels of detail"));
    S3mbStream skeletons = stream.takeStream("the skeletons");
    const std::size_t count = skeletons.takeCount(4);
    for (std::size_t i = 0; i < count; ++i) {
        S3mbStream skeleton = skeletons.takeStream("a skeleton");
        const std::string name = skeleton.takeString();
        skeleton.align();
        auto points = parseS3mbSkeleton(skeleton, tile.bytes, version, job);
        if (!points)
            ++tile.meshes;
        else if (!tile.skeletons.emplace(name, std::move(*points)).second)
            skeleton.refuse("two skeletons have the name " + name.substr(0, 60), "different names");
    }
    return tile;
}

}  // namespace vestige
