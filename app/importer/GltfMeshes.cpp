#include "app/importer/GltfMeshes.h"

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/importer/Streams.h"
#include "core/base/Result.h"

namespace vestige::importer {
namespace {

constexpr const char* kDocument = "scene.gltf";
constexpr const char* kExpected = "a valid glTF 2.0 file";

class MemoryStream : public Assimp::IOStream {
  public:
    explicit MemoryStream(std::span<const std::byte> bytes) : bytes_(bytes) {}
    std::size_t Read(void* into, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t items = std::min(count, (bytes_.size() - at_) / size);
        if (items > 0) std::memcpy(into, bytes_.data() + at_, items * size);
        at_ += items * size;
        return items;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t from = origin == aiOrigin_SET ? 0 : (origin == aiOrigin_CUR ? at_ : bytes_.size());
        if (offset > bytes_.size() - std::min(from, bytes_.size())) return aiReturn_FAILURE;
        at_ = from + offset;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

  private:
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

/// The only files there are: the document and its buffers.
class Files : public Assimp::IOSystem {
  public:
    void add(const std::string& name, std::span<const std::byte> bytes) { files_.emplace(name, bytes); }
    bool Exists(const char* name) const override { return files_.contains(plain(name)); }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char*) override {
        const auto found = files_.find(plain(name));
        return found == files_.end() ? nullptr : new MemoryStream(found->second);
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

  private:
    static std::string plain(std::string name) {
        while (name.starts_with("./") || name.starts_with('/')) name.erase(0, name.find('/') + 1);
        return name;
    }
    std::map<std::string, std::span<const std::byte>> files_;
};

void keepGltfOnly(Assimp::Importer& importer) {
    std::vector<Assimp::BaseImporter*> others;
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
        const aiImporterDesc* facts = importer.GetImporterInfo(i);
        if (!facts || std::string_view(facts->mName) != "glTF2 Importer")
            others.push_back(importer.GetImporter(i));
    }
    for (Assimp::BaseImporter* other : others) importer.UnregisterLoader(other);
}

std::uint16_t channel(float value) {
    return std::isfinite(value)
               ? static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535.0F))
               : std::uint16_t{0};
}

Eigen::Vector3f vectorOf(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

ImportedMesh converted(const aiMesh& mesh) {
    ImportedMesh result;
    const std::size_t count = mesh.mNumVertices;
    for (std::size_t i = 0; i < count; ++i)
        result.vertices.push_back(vectorOf(mesh.mVertices[i]).cast<double>());
    if (mesh.mNormals)
        for (std::size_t i = 0; i < count; ++i) result.normals.push_back(vectorOf(mesh.mNormals[i]));
    if (const aiColor4D* colors = mesh.mColors[0])
        for (std::size_t i = 0; i < count; ++i)
            result.colors.push_back({channel(colors[i].r), channel(colors[i].g), channel(colors[i].b)});
    for (std::size_t i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices == 3)
            result.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    return result;
}

}  // namespace

void sendGltf(const std::string& request, ImportSender& sender) {
    const auto fields = nlohmann::json::parse(request);
    const std::string document = fields.at("document").get<std::string>();
    auto* files = new Files;  // the importer's own from here on
    Assimp::Importer importer;
    importer.SetIOHandler(files);
    keepGltfOnly(importer);
    files->add(kDocument, std::as_bytes(std::span(document)));
    std::size_t number = 0;
    for (const auto& buffer : fields.at("buffers")) {
        const auto whole = mapped(buffer.at("file").get<int>());
        const auto offset = buffer.at("offset").get<std::size_t>();
        const auto length = buffer.at("length").get<std::size_t>();
        if (offset > whole.size() || length > whole.size() - offset)
            throw ErrorException{{ErrorCode::input, "the file changed while it was read", {}, kExpected}};
        files->add(std::to_string(number++), whole.subspan(offset, length));
    }
    const aiScene* scene = importer.ReadFile(kDocument, 0);
    if (!scene || !scene->mRootNode)
        throw ErrorException{{ErrorCode::input,
                              "Assimp cannot read the file: " + std::string(importer.GetErrorString()),
                              {},
                              kExpected}};
    // Assimp orders its meshes by their first use, which is the order of the nodes.
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) sender.mesh(converted(*scene->mMeshes[i]));
}

}  // namespace vestige::importer
