#include "core/io/formats/GltfFormat.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/io/AttributeNames.h"
#include "core/io/Describe.h"
#include "core/io/MappedFile.h"
#include "core/io/formats/GltfBuffers.h"
#include "core/io/formats/GltfScene.h"
#include "core/io/formats/GltfWriter.h"
#include "core/io/importer/ImporterProcess.h"
#include "core/io/importer/ImporterProtocol.h"

namespace vestige {
namespace {

/// How many vertices a file may always grow to by standing in its scene many times, and how often its own
/// ones may be repeated beyond.
constexpr std::uint64_t kVerticesAllowed = 10'000'000;
constexpr std::uint64_t kRepeats = 16;
constexpr std::uint64_t kVertexBytes = 12;

std::string versionText(bool isBinary) {
    return isBinary ? "2.0, binary" : "2.0, text";
}

struct Parsed {
    GltfScene scene;
    std::vector<GltfBuffer> buffers;
    bool isBinary = false;
};

Parsed parse(const MappedFile& content, ReadJob& job) {
    const GltfContainer container = splitGltf(content.bytes(), job);
    const nlohmann::json document = parseGltfJson(container.json, container.jsonByte, job);
    Parsed parsed;
    parsed.isBinary = container.isBinary;
    parsed.scene = readGltfScene(document, job);
    parsed.buffers = findGltfBuffers(GltfJson(document, job), container, parsed.scene.buffers);
    return parsed;
}

std::uint64_t mostVertices(const Parsed& parsed, std::uint64_t fileBytes) {
    for (const GltfBuffer& buffer : parsed.buffers) fileBytes += buffer.length;
    return kVerticesAllowed + kRepeats * (fileBytes / kVertexBytes);
}

/// Primitives may share accessors, and instances primitives.
void checkRepeats(const GltfScene& scene, std::uint64_t mostVertices, const ReadJob& job) {
    const auto check = [&](const char* what, std::uint64_t GltfPrimitive::*count, std::uint64_t most) {
        std::uint64_t sent = 0, placed = 0;
        for (const GltfPrimitive& primitive : scene.primitives) sent += primitive.*count;
        for (const ImportedInstance& instance : scene.instances)
            placed += scene.primitives[instance.mesh].*count;
        if (std::max(sent, placed) > most)
            job.refuse(std::string("the file repeats its ") + what + " until it has " +
                           std::to_string(std::max(sent, placed)),
                       "at most " + std::to_string(most) + " for a file of its size");
    };
    check("vertices", &GltfPrimitive::vertices, mostVertices);
    check("triangles", &GltfPrimitive::triangles, kTrianglesOfVertex * mostVertices);
}

ImportRequest requestOf(const Parsed& parsed, ReadJob& job) {
    ImportRequest request;
    request.format = "gltf";
    request.memoryBytes = importMemoryFor(parsed.scene.bytes + parsed.scene.document.size());
    request.time = importTimeFor(parsed.scene.bytes + parsed.scene.document.size());
    // Coordinates come back as double, triangles as 12 bytes for what may be three bytes of the file.
    constexpr std::uint64_t kBlocks = 4;  // vertices, normals, colours, triangles
    request.resultBytes =
        65536 + 8 * parsed.scene.bytes + kBlocks * kImportBlockCost * parsed.scene.primitives.size();
    nlohmann::json words = {{"document", parsed.scene.document}, {"buffers", nlohmann::json::array()}};
    std::map<std::filesystem::path, int> numbers;
    for (const GltfBuffer& buffer : parsed.buffers) {
        constexpr int kFirst = 3;
        constexpr std::size_t kMostFiles = 128;
        int number = kFirst + static_cast<int>(request.files.size());
        if (request.files.size() >= kMostFiles)
            job.refuse("the scene has its bytes in more than " + std::to_string(kMostFiles) + " buffers",
                       "fewer buffers");
        if (buffer.decoded) {
            request.files.push_back(fileInMemory(*buffer.decoded));
        } else if (const auto known = numbers.find(buffer.file); known != numbers.end()) {
            number = known->second;
        } else {
            if (buffer.file.filename() != job.path().filename()) job.alsoReads(buffer.file);
            request.files.push_back(openForReading(buffer.file));
            numbers.emplace(buffer.file, number);
        }
        words["buffers"].push_back({{"file", number}, {"offset", buffer.offset}, {"length", buffer.length}});
    }
    request.request = words.dump();
    return request;
}

/// Assimp must give back every primitive, whole; else something of the file would be missing in silence.
void checkAgainst(const std::vector<GltfPrimitive>& primitives, ImportedScene& found, const ReadJob& job) {
    if (found.meshes.size() != primitives.size())
        job.refuse("Assimp reads " + counted(found.meshes.size(), "mesh") + " of the file",
                   std::to_string(primitives.size()) + " primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        ImportedMesh& mesh = found.meshes[i];
        if (mesh.vertices.size() != primitives[i].vertices ||
            mesh.triangles.size() != primitives[i].triangles)
            job.refuse("of the vertices and triangles of a mesh only " +
                           std::to_string(mesh.vertices.size()) + " and " +
                           std::to_string(mesh.triangles.size()) + " can be read",
                       "indices below the number of vertices, " + std::to_string(primitives[i].vertices) +
                           " of these and " + std::to_string(primitives[i].triangles) + " triangles");
        if (!primitives[i].normals) mesh.normals.clear();
        if (!primitives[i].colors) mesh.colors.clear();
    }
}

}  // namespace

bool GltfFormat::recognises(std::span<const std::byte> head, std::string_view extension) const {
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    return text.starts_with("glTF") || extension == "gltf";
}

Result<FileInfo> GltfFormat::peek(const std::filesystem::path& file, const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<FileInfo> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        const Parsed parsed = parse(*content, job);
        FileInfo info;
        info.path = file;
        info.format = "glTF";
        info.version = versionText(parsed.isBinary);
        info.generatingSoftware = parsed.scene.generator;
        info.metresPerUnit = 1;
        bool normals = false, colors = false;
        for (const ImportedInstance& instance : parsed.scene.instances) {
            const GltfPrimitive& primitive = parsed.scene.primitives[instance.mesh];
            info.points += primitive.vertices;
            info.triangles += primitive.triangles;
            normals = normals || primitive.normals;
            colors = colors || primitive.colors;
            for (int corner = 0; primitive.bounds && corner < 8; ++corner) {
                Eigen::Vector3d point;
                for (int axis = 0; axis < 3; ++axis)
                    point[axis] = (corner >> axis & 1 ? primitive.bounds->max : primitive.bounds->min)[axis];
                info.bounds.add(instance.fileFromMesh * point);
            }
        }
        info.attributes = attributeNames({.color = colors, .normals = normals});
        return info;
    });
}

Result<LoadedGeometry> GltfFormat::read(const std::filesystem::path& file, const ReadOptions& /*options*/,
                                        const JobControl& control) const {
    return guarded(file.string(), [&]() -> Result<LoadedGeometry> {
        const Result<MappedFile> content = MappedFile::open(file);
        if (!content) return fail(content.error());
        ReadJob job(file, control);
        Parsed parsed = parse(*content, job);
        const std::uint64_t most = mostVertices(parsed, content->bytes().size());
        checkRepeats(parsed.scene, most, job);
        ImportedScene scene;
        if (!parsed.scene.primitives.empty()) scene = importScene(requestOf(parsed, job), job, control);
        checkAgainst(parsed.scene.primitives, scene, job);
        scene.instances = std::move(parsed.scene.instances);
        LoadedGeometry result =
            loaded(assembleScene(std::move(scene), most, job), "glTF", versionText(parsed.isBinary), job);
        result.info.metresPerUnit = 1;
        result.info.generatingSoftware = parsed.scene.generator;
        return result;
    });
}

Status GltfFormat::write(const std::filesystem::path& file, const TriangleMesh& geometry,
                         const WriteOptions& options, const JobControl& control) const {
    return writeGltf(file, geometry, options, control);
}

}  // namespace vestige
