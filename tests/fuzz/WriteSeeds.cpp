// Seeds that no file under ../shared/data gives, small and of our own making: write_seeds TARGET FOLDER.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "core/geometry/PointCloudBuilder.h"
#include "core/io/Bytes.h"
#include "core/io/FormatRegistry.h"
#include "core/io/importer/ImporterProtocol.h"
#include "core/scene/CaseFile.h"
#include "core/scene/store/CaseStore.h"
#include "tests/core/io/E57Craft.h"
#include "tests/core/io/S3mbFiles.h"

using namespace vestige;

namespace {

namespace fs = std::filesystem;

TriangleMesh smallGeometry(std::size_t points, bool triangles) {
    PointCloudBuilder builder(Eigen::Vector3d(500000, 4400000, 30));
    for (std::size_t i = 0; i < points; ++i) {
        const double angle = 0.7 * static_cast<double>(i);
        builder.add({500000 + 5 * std::cos(angle), 4400000 + 3 * std::sin(angle), 30 + 0.25 * angle});
        PointAttributes& attributes = builder.attributes();
        const auto number = static_cast<std::uint16_t>(257 * (i % 256));
        attributes.intensity.push_back(number);
        attributes.color.push_back({number, 0, 65535});
        attributes.classification.push_back(static_cast<std::uint8_t>(i % 7));
        attributes.gpsTime.push_back(1000 + 0.001 * static_cast<double>(i));
    }
    TriangleMesh mesh{std::move(builder).build(), {}};
    for (std::uint32_t i = 0; triangles && i + 2 < points; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
    return mesh;
}

std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string written(const fs::path& folder, const std::string& extension, const TriangleMesh& geometry) {
    const fs::path file = folder / ("made." + extension);
    if (const Status done = writeGeometry(file, geometry, {}); !done)
        std::fprintf(stderr, "%s\n", done.error().sentence().c_str());
    const std::string bytes = contentOf(file);
    fs::remove(file);
    return bytes;
}

/// A LAZ file as COPC: an info record behind its header, and at its end an octree of one node.
std::string asCopc(const std::string& laz) {
    constexpr std::size_t kRecord = 54, kInfo = 160;
    std::string file = laz;
    const auto at = [&](std::size_t place) { return reinterpret_cast<std::byte*>(file.data()) + place; };
    const auto headerSize = load<std::uint16_t>(at(94));
    const auto pointOffset = load<std::uint32_t>(at(96));
    const auto points = load<std::uint64_t>(at(247));
    file.insert(headerSize, kRecord + kInfo, '\0');
    constexpr std::size_t kAdded = kRecord + kInfo;
    file.replace(headerSize + 2, 4, "copc");
    store<std::uint16_t>(at(headerSize + 18), 1);
    store<std::uint16_t>(at(headerSize + 20), kInfo);
    store<std::uint32_t>(at(96), pointOffset + kAdded);
    store<std::uint32_t>(at(100), load<std::uint32_t>(at(100)) + 1);
    store(at(pointOffset + kAdded), load<std::int64_t>(at(pointOffset + kAdded)) + std::int64_t{kAdded});
    const std::size_t info = headerSize + kRecord;
    const std::uint64_t hierarchy = file.size();
    for (const auto& [place, number] :
         {std::pair<std::size_t, double>{0, 500000}, {8, 4400000}, {16, 30}, {24, 64}, {32, 1}})
        store(at(info + place), number);
    store(at(info + 40), hierarchy);
    store(at(info + 48), std::uint64_t{32});
    std::string node(32, '\0');
    auto* entry = reinterpret_cast<std::byte*>(node.data());
    store(entry + 16, std::uint64_t{pointOffset + kAdded + 8});
    store(entry + 24, std::int32_t{1});
    store(entry + 28, static_cast<std::int32_t>(points));
    return file + node;
}

std::string craftedE57() {
    test::E57Craft craft;
    const std::uint64_t at = craft.section(test::E57Craft::packet(
        {test::bytesOf<double>({2, 4, 1, 8}), test::bytesOf<double>({0, 1, 0, 0}),
         test::bytesOf<double>({0, 0, 0, 1}), test::bytesOf<std::uint8_t>({0b00010000}),
         test::bytesOf<std::uint16_t>({5, 6, 7, 8}), test::bytesOf<std::uint8_t>({1, 2, 3, 4})}));
    const std::uint64_t image = craft.blob("\xff\xd8\xff");
    return craft.file(test::E57Craft::root(
        test::E57Craft::scan(
            at, 4,
            "<sphericalRange type=\"Float\"/><sphericalAzimuth type=\"Float\"/><sphericalElevation "
            "type=\"Float\"/><sphericalInvalidState type=\"Integer\" minimum=\"0\" maximum=\"2\"/>"
            "<intensity type=\"ScaledInteger\" minimum=\"0\" maximum=\"65535\" scale=\"0.5\" offset=\"1\"/>"
            "<colorRed type=\"Integer\" minimum=\"0\" maximum=\"255\"/>",
            "<name type=\"String\"><![CDATA[a]]></name><pose type=\"Structure\"><rotation "
            "type=\"Structure\"><w type=\"Float\">1</w><x type=\"Float\"/><y type=\"Float\"/><z "
            "type=\"Float\"/></rotation><translation type=\"Structure\"><x type=\"Float\">5e5</x><y "
            "type=\"Float\"/><z type=\"Float\"/></translation></pose>"),
        "<images2D type=\"Vector\"><vectorChild type=\"Structure\"><pinholeRepresentation "
        "type=\"Structure\"><jpegImage type=\"Blob\" fileOffset=\"" +
            std::to_string(image) + "\" length=\"3\"/></pinholeRepresentation></vectorChild></images2D>"));
}

std::vector<std::string> s3mbSeeds() {
    test::S3mbPoints first;
    first.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    first.colors = {0xff030201, 0xff0000ff, 0xffff0000};
    first.intensities = {10, 200, 3000};
    first.place = {500000.25, 4400000.5, -12.125};
    test::S3mbPoints second;
    second.name = "b";
    second.positions = {{0.5F, 0, 0}};
    second.child = "tile.s3mb";
    std::vector<std::string> seeds;
    for (const std::uint32_t packing : {0, 1, 2})
        seeds.push_back(test::s3mbFile(test::s3mbPackage({first, second}), packing));
    return seeds;
}

/// What an importer sends, without the mark before and the checksum behind.
std::string sentMeshes() {
    std::string sent;
    ImportSender sender([&](std::span<const std::byte> bytes) {
        sent.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });
    ImportedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {{0, 1, 2}}};
    mesh.normals.assign(3, Eigen::Vector3f::UnitZ());
    mesh.colors.assign(3, Color{1, 2, 65535});
    sender.warning("a warning");
    sender.unit(0.001);
    sender.mesh(mesh);
    const std::vector<ImportedInstance> places(2);
    sender.instances(places);
    return sent.substr(8);
}

/// A saved case with an edit that was not, as databases.
std::vector<std::string> storeSeeds(const fs::path& folder) {
    const fs::path place = folder / "seed.vestige";
    SceneState scene;
    scene.name = "night";
    scene.operatorName = "A. Nalyst";
    static_cast<void>(writeCase(place, scene));
    const std::string saved = contentOf(place / "case.db");
    if (auto store = CaseStore::open(place)) {
        scene.operatorName = "B. Nalyst";
        static_cast<void>((*store)->append({{"case details", scene}}));
    }
    std::vector<std::string> seeds{saved, contentOf(place / "case.db")};
    fs::remove_all(place);
    return seeds;
}

std::vector<std::string> seedsOf(const std::string& target, const fs::path& folder) {
    if (target == "laz" || target == "copc") {
        const std::string small = written(folder, "laz", smallGeometry(40, false));
        return {small, asCopc(small), written(folder, "laz", smallGeometry(700, false))};
    }
    if (target == "e57") return {craftedE57(), written(folder, "e57", smallGeometry(50, false))};
    if (target == "gltf") return {written(folder, "glb", smallGeometry(12, true))};
    if (target == "s3mb") return s3mbSeeds();
    if (target == "scp")
        return {test::s3mbIndex("Add", {"tile.s3mb"}, R"(,"crs":"epsg:4547","position":{"unit":"Meter",
                    "point3D":{"x":499999.125,"y":4400000.5,"z":31}})"),
                test::s3mbIndex("Replace", {"./tile.s3mb"}, R"(,"position":{"unit":"Degree",
                    "point3D":{"x":116,"y":40,"z":31}})")};
    if (target == "store") return storeSeeds(folder);
    if (target == "protocol") return {sentMeshes()};
    return {};
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) return 2;
    const fs::path folder = words[2];
    int number = 0;
    for (const std::string& content : seedsOf(words[1], folder))
        std::ofstream(folder / ("made-" + std::to_string(number++)), std::ios::binary) << content;
    return 0;
}
