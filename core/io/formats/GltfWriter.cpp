#include "core/io/formats/GltfWriter.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/Numbers.h"
#include "core/io/Bytes.h"
#include "core/io/WriteJob.h"
#include "core/io/formats/Base64.h"
#include "core/io/formats/GltfPieces.h"

namespace vestige {
namespace {

using nlohmann::json;

constexpr std::size_t kFloat = 5126, kByte = 5121, kShort = 5123, kInt = 5125;
constexpr std::size_t kArrayBuffer = 34962, kElementBuffer = 34963;
/// Stands in the JSON for the bytes, which are never held as a whole.
constexpr std::string_view kBytesHere = "BYTES-HERE";

using ByteSink = std::function<void(std::span<const std::byte>)>;

class GltfDocument {
  public:
    GltfDocument(const TriangleMesh& mesh, const JobControl& control)
        : mesh_(mesh), attributes_(mesh.vertices.attributes()), control_(control), pieces_(gltfPieces(mesh)) {
        bytes_ = colorsAreBytes(mesh.vertices);
        const auto& normals = attributes_.normal;
        normals_ = !normals.empty() && std::none_of(normals.begin(), normals.end(),
                                                    [](const Eigen::Vector3f& n) { return n.isZero(); });
        if (!normals.empty() && !normals_)
            control.message("normals are not written: glTF has no place for points without one");
        describe();
    }

    std::size_t binaryBytes() const { return offset_; }

    std::string text(bool inside) const {
        json document = document_;
        if (offset_ > 0) {
            document["buffers"] = json::array({{{"byteLength", offset_}}});
            if (inside) document["buffers"][0]["uri"] = kBytesHere;
        }
        return document.dump();
    }

    /// What the buffer views hold, in their order.
    void writeBinary(const ByteSink& sink) const {
        for (const GltfPiece& piece : pieces_) {
            const auto write = [&]<class Value>(std::size_t count, Value&& value) {
                using Item = decltype(value(std::size_t{}));
                std::vector<Item> buffer;
                for (std::size_t i = 0; i < count; ++i) {
                    stepWriting(control_, i, count);
                    buffer.push_back(value(i));
                    if (buffer.size() < 4096 && i + 1 < count) continue;
                    sink(std::as_bytes(std::span(buffer)));
                    buffer.clear();
                }
            };
            const std::size_t count = size(piece);
            write(count, [&](std::size_t i) -> std::array<float, 3> {
                const Eigen::Vector3f p = position(piece, i);
                return {p.x(), p.y(), p.z()};
            });
            if (normals_)
                write(count, [&](std::size_t i) -> std::array<float, 3> {
                    const Eigen::Vector3f& n = attributes_.normal[point(piece, i)];
                    return {n.x(), n.y(), n.z()};
                });
            if (!attributes_.color.empty() && bytes_)
                write(count, [&](std::size_t i) -> std::array<std::uint8_t, 4> {
                    const Color& c = attributes_.color[point(piece, i)];
                    const auto byte = [](std::uint16_t word) {
                        return static_cast<std::uint8_t>(word / 257);
                    };
                    return {byte(c[0]), byte(c[1]), byte(c[2]), 255};
                });
            else if (!attributes_.color.empty())
                write(count, [&](std::size_t i) -> std::array<std::uint16_t, 4> {
                    const Color& c = attributes_.color[point(piece, i)];
                    return {c[0], c[1], c[2], 65535};
                });
            const std::vector<Triangle>& triangles = trianglesOf(piece);
            write(triangles.size(), [&](std::size_t i) { return triangles[i]; });
        }
    }

  private:
    static std::size_t point(const GltfPiece& piece, std::size_t i) {
        return piece.everything ? i : piece.points[i];
    }
    std::size_t size(const GltfPiece& piece) const {
        return piece.everything ? mesh_.vertices.size() : piece.points.size();
    }
    const std::vector<Triangle>& trianglesOf(const GltfPiece& piece) const {
        return piece.everything ? mesh_.triangles : piece.triangles;
    }
    Eigen::Vector3f position(const GltfPiece& piece, std::size_t i) const {
        return (mesh_.vertices.point(point(piece, i)) - piece.origin).cast<float>();
    }

    void describe() {
        document_ = {{"asset", {{"version", "2.0"}, {"generator", "Vestige"}}}, {"scene", 0}};
        document_["scenes"] = json::array({json::object()});
        if (pieces_.empty()) return;
        document_["scenes"][0]["nodes"] = json::array({0});
        document_["extensionsUsed"] = json::array({"KHR_materials_unlit"});
        json plain = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}},
                      {"doubleSided", true}};
        if (!normals_)
            plain["extensions"] = {{"KHR_materials_unlit", json::object()}};
        else
            document_.erase("extensionsUsed");
        document_["materials"] = json::array({std::move(plain)});
        // Column after column: x stays, y becomes -z, z becomes y.
        json root = {
            {"name", "z up"},
            {"matrix", {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}},
            {"children", json::array()}};
        document_["nodes"] = json::array({nullptr});
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            root["children"].push_back(i + 1);
            const Eigen::Vector3d& origin = pieces_[i].origin;
            document_["nodes"].push_back(
                {{"mesh", i}, {"translation", {origin.x(), origin.y(), origin.z()}}});
            describe(pieces_[i]);
        }
        document_["nodes"][0] = std::move(root);
    }

    void describe(const GltfPiece& piece) {
        const std::size_t count = size(piece);
        Eigen::Vector3f low = position(piece, 0), high = low;
        for (std::size_t i = 1; i < count; ++i) {
            const Eigen::Vector3f p = position(piece, i);
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        json attributes = {{"POSITION", accessor(count, 12, "VEC3", kFloat, kArrayBuffer)}};
        document_["accessors"].back()["min"] = {low.x(), low.y(), low.z()};
        document_["accessors"].back()["max"] = {high.x(), high.y(), high.z()};
        if (normals_) attributes["NORMAL"] = accessor(count, 12, "VEC3", kFloat, kArrayBuffer);
        if (!attributes_.color.empty()) {
            attributes["COLOR_0"] =
                accessor(count, bytes_ ? 4 : 8, "VEC4", bytes_ ? kByte : kShort, kArrayBuffer);
            document_["accessors"].back()["normalized"] = true;
        }
        const std::size_t triangles = trianglesOf(piece).size();
        json primitive = {
            {"mode", triangles > 0 ? 4 : 0}, {"material", 0}, {"attributes", std::move(attributes)}};
        if (triangles > 0) primitive["indices"] = accessor(3 * triangles, 4, "SCALAR", kInt, kElementBuffer);
        document_["meshes"].push_back({{"primitives", json::array({std::move(primitive)})}});
    }

    std::size_t accessor(std::size_t count, std::size_t bytes, const char* type, std::size_t component,
                         std::size_t target) {
        const std::size_t view = document_["bufferViews"].size();
        document_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", offset_}, {"byteLength", count * bytes}, {"target", target}});
        document_["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        offset_ += count * bytes;
        return view;
    }

    const TriangleMesh& mesh_;
    const PointAttributes& attributes_;
    const JobControl& control_;
    std::vector<GltfPiece> pieces_;
    json document_;
    std::size_t offset_ = 0;
    bool normals_ = false, bytes_ = false;
};

void writeBinaryFile(AtomicFile& target, const GltfDocument& document) {
    std::string text = document.text(false);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t binary = document.binaryBytes();
    const std::size_t whole = 12 + 8 + text.size() + (binary > 0 ? 8 + binary : 0);
    std::byte words[12];
    const auto put = [&](std::uint32_t a, std::uint32_t b) {
        store(words, a);
        store(words + 4, b);
        target.write(std::span<const std::byte>(words, 8));
    };
    put(0x46546c67, 2);
    store(words, static_cast<std::uint32_t>(whole));
    target.write(std::span<const std::byte>(words, 4));
    put(static_cast<std::uint32_t>(text.size()), 0x4e4f534a);
    target.write(text);
    if (binary == 0) return;
    put(static_cast<std::uint32_t>(binary), 0x004e4942);
    document.writeBinary([&](std::span<const std::byte> bytes) { target.write(bytes); });
}

void writeTextFile(AtomicFile& target, const GltfDocument& document) {
    const std::string text = document.text(true);
    const std::size_t cut = std::min(text.find(kBytesHere), text.size());
    target.write(std::string_view(text).substr(0, cut));
    if (cut == text.size()) return;
    target.write("data:application/octet-stream;base64,");
    std::vector<std::byte> waiting;
    document.writeBinary([&](std::span<const std::byte> bytes) {
        waiting.insert(waiting.end(), bytes.begin(), bytes.end());
        const std::size_t whole = waiting.size() / 3 * 3;
        target.write(base64Of(std::span(waiting).first(whole)));
        waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(whole));
    });
    target.write(base64Of(waiting));
    target.write(std::string_view(text).substr(cut + kBytesHere.size()));
}

}  // namespace

Status writeGltf(const std::filesystem::path& file, const TriangleMesh& geometry, const WriteOptions& options,
                 const JobControl& control) {
    return writeAtomically(file, [&](AtomicFile& target) {
        if (options.source && options.source->metresPerUnit.value_or(1) != 1)
            control.message("coordinates are written as they are, but a unit of the source is " +
                            exactText(*options.source->metresPerUnit) + " m, and glTF counts in metres");
        const GltfDocument document(geometry, control);
        constexpr std::size_t kMost = 0xffffffff - (std::size_t{1} << 20);
        if (document.binaryBytes() > kMost)
            throw ErrorException{{ErrorCode::output, "this is more than a glTF file can hold, 4 GiB",
                                  file.string(), "write LAS or PLY, or thin the points"}};
        std::string extension = file.extension().string();
        std::transform(extension.begin(), extension.end(), extension.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        if (extension == ".gltf")
            writeTextFile(target, document);
        else
            writeBinaryFile(target, document);
    });
}

}  // namespace vestige
