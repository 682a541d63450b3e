#include "core/io/formats/GltfScene.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/io/formats/GltfAccessors.h"
#include "core/io/formats/GltfNodes.h"

namespace vestige {
namespace {

using nlohmann::json;

constexpr std::uint64_t kFloat = 5126, kByte = 5121, kShort = 5123, kInt = 5125;
constexpr std::size_t kMostInstances = 1'000'000;
/// Materials and textures change nothing of the geometry.
constexpr std::string_view kHarmless[] = {
    "KHR_texture_transform", "KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif",
    "KHR_lights_punctual",   "KHR_xmp_json_ld",    "KHR_xmp"};

class SceneReader {
  public:
    SceneReader(const json& document, ReadJob& job)
        : document_(document, job), job_(job), accessors_(document_) {}

    GltfScene read() {
        checkVersion();
        for (const GltfMeshPlace& place : walkGltfNodes(document_)) {
            const auto& [first, last] = primitivesOf(place.mesh);
            for (std::uint32_t i = first; i < last; ++i) scene_.instances.push_back({i, place.worldFromMesh});
            if (scene_.instances.size() > kMostInstances)
                job_.refuse("the scene repeats its meshes without end",
                            "at most " + std::to_string(kMostInstances) + " primitives at their places");
        }
        for (const std::string& warning : warnings_) job_.warn(warning);
        scene_.buffers = accessors_.buffers();
        scene_.document = checkedDocument();
        return std::move(scene_);
    }

  private:
    void checkVersion() {
        const json& document = document_.document();
        if (!document.is_object() || !document.contains("asset"))
            job_.refuse("the document says no version", "'asset' with the version \"2.0\"");
        const std::string version = document_.text(document["asset"], "version");
        if (!version.starts_with("2."))
            job_.refuse("this is glTF of the version '" + version.substr(0, 20) + "'", "version 2");
        scene_.generator = document_.text(document["asset"], "generator");
        for (const std::string& name : document_.texts(document, "extensionsRequired"))
            if (std::find(std::begin(kHarmless), std::end(kHarmless), name) == std::end(kHarmless) &&
                !name.starts_with("KHR_materials_"))
                job_.refuse(
                    "the file requires the extension " + name.substr(0, 100) + ", which is not read here",
                    "a file without it; most programs can export one");
        for (const std::string& name : document_.texts(document, "extensionsUsed"))
            if (name == "EXT_mesh_gpu_instancing")
                warnings_.insert("copies by EXT_mesh_gpu_instancing are left out");
        if (document_.count("animations") > 0) warnings_.insert("animations are left out");
        if (document_.count("skins") > 0)
            warnings_.insert("skins are left out: their meshes stand as they are stored");
    }

    /// The range of numbers of a mesh's primitives.
    const std::pair<std::uint32_t, std::uint32_t>& primitivesOf(std::uint64_t mesh) {
        const auto known = meshes_.find(mesh);
        if (known != meshes_.end()) return known->second;
        const json& from = document_.item("meshes", mesh, "a node");
        const std::string why = "mesh " + std::to_string(mesh);
        if (!from.contains("primitives") || !from["primitives"].is_array())
            job_.refuse(why + " has no primitives", "a list of them");
        const auto first = static_cast<std::uint32_t>(scene_.primitives.size());
        for (const json& primitive : from["primitives"]) addPrimitive(primitive, why);
        return meshes_.emplace(mesh, std::pair{first, static_cast<std::uint32_t>(scene_.primitives.size())})
            .first->second;
    }

    void addPrimitive(const json& from, const std::string& why) {
        const std::uint64_t mode = document_.number(from, "mode", 4);
        if (mode > 6) job_.refuse(why + " has the mode " + std::to_string(mode), "0 to 6");
        if (mode >= 1 && mode <= 3) {
            warnings_.insert("lines are left out");
            return;
        }
        if (from.contains("extensions") && (from["extensions"].contains("KHR_draco_mesh_compression")))
            job_.refuse(why + " is compressed by KHR_draco_mesh_compression, which is not read here",
                        "a file without it; most programs can export one");
        if (from.contains("targets")) warnings_.insert("morph targets are left out");
        if (!from.contains("attributes") || !from["attributes"].is_object())
            job_.refuse(why + " has no attributes", "a position for each vertex");
        const json& attributes = from["attributes"];
        if (!attributes.contains("POSITION")) {
            warnings_.insert("a primitive without positions is left out");
            return;
        }
        GltfPrimitive primitive;
        const std::uint64_t positionIndex = document_.number(attributes, "POSITION");
        const GltfAccessor position = accessors_.take(positionIndex, why);
        if (position.type != "VEC3" || position.componentType != kFloat)
            job_.refuse("the positions of " + why + " are not float vectors",
                        "VEC3 of the component type 5126");
        primitive.vertices = position.count;
        primitive.bounds = boundsOf(document_.item("accessors", positionIndex, why));
        json to = {{"mode", mode}, {"attributes", {{"POSITION", position.number}}}};
        scene_.bytes += position.bytes;
        takeNormals(attributes, primitive, to, why);
        takeColors(attributes, primitive, to, why);
        std::uint64_t corners = primitive.vertices;
        if (const auto index = document_.find(from, "indices")) {
            const GltfAccessor indices = accessors_.take(*index, why);
            if (indices.type != "SCALAR" ||
                (indices.componentType != kByte && indices.componentType != kShort &&
                 indices.componentType != kInt))
                job_.refuse("the indices of " + why + " are no whole numbers",
                            "scalars of the component type 5121, 5123 or 5125");
            corners = indices.count;
            scene_.bytes += 4 * corners;
            if (mode == 0)
                warnings_.insert("points are all read, also those that the file's indices leave out");
            else
                to["indices"] = indices.number;
        }
        if (mode == 4) primitive.triangles = corners / 3;
        if (mode > 4) primitive.triangles = corners < 3 ? 0 : corners - 2;
        if (mode != 0 && primitive.triangles == 0) {
            warnings_.insert("a primitive without a whole triangle is left out");
            return;
        }
        if (mode == 4 && corners % 3 != 0)
            warnings_.insert("corners behind the last whole triangle are left out");
        const std::string name = std::to_string(scene_.primitives.size());
        newMeshes_.push_back({{"name", name}, {"primitives", json::array({std::move(to)})}});
        scene_.primitives.push_back(primitive);
    }

    void takeNormals(const json& attributes, GltfPrimitive& primitive, json& to, const std::string& why) {
        if (!attributes.contains("NORMAL")) return;
        const GltfAccessor normal = accessors_.take(document_.number(attributes, "NORMAL"), why);
        checkCount(normal, primitive, "normals", why);
        if (normal.type != "VEC3" || normal.componentType != kFloat) {
            warnings_.insert("normals that are not float vectors are left out");
            return;
        }
        primitive.normals = true;
        to["attributes"]["NORMAL"] = normal.number;
        scene_.bytes += normal.bytes;
    }

    void takeColors(const json& attributes, GltfPrimitive& primitive, json& to, const std::string& why) {
        if (!attributes.contains("COLOR_0")) return;
        const GltfAccessor color = accessors_.take(document_.number(attributes, "COLOR_0"), why);
        checkCount(color, primitive, "colours", why);
        const bool whole =
            color.normalized && (color.componentType == kByte || color.componentType == kShort);
        if ((color.type != "VEC3" && color.type != "VEC4") || (color.componentType != kFloat && !whole)) {
            warnings_.insert("colours that are neither fractions nor normalised bytes or words are left out");
            return;
        }
        primitive.colors = true;
        to["attributes"]["COLOR_0"] = color.number;
        scene_.bytes += 16 * color.count;
    }

    void checkCount(const GltfAccessor& accessor, const GltfPrimitive& primitive, const std::string& what,
                    const std::string& why) const {
        if (accessor.count != primitive.vertices)
            job_.refuse(why + " has " + std::to_string(accessor.count) + " " + what,
                        std::to_string(primitive.vertices) + ", one for each vertex");
    }

    std::optional<BoundingBox> boundsOf(const json& accessor) const {
        const auto low = document_.reals(accessor, "min", 3);
        const auto high = document_.reals(accessor, "max", 3);
        if (!low || !high) return std::nullopt;
        return BoundingBox{Eigen::Vector3d(low->data()), Eigen::Vector3d(high->data())};
    }

    std::string checkedDocument() {
        json document = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
        json nodes = json::array(), roots = json::array();
        for (std::size_t i = 0; i < newMeshes_.size(); ++i) {
            nodes.push_back({{"name", "node" + std::to_string(i)}, {"mesh", i}});
            roots.push_back(i);
        }
        document["nodes"] = std::move(nodes);
        document["scenes"] = json::array({{{"nodes", std::move(roots)}}});
        document["meshes"] = std::move(newMeshes_);
        std::move(accessors_).putInto(document);
        return document.dump();
    }

    GltfJson document_;
    ReadJob& job_;
    GltfAccessors accessors_;
    GltfScene scene_;
    std::map<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>> meshes_;
    std::vector<json> newMeshes_;
    std::set<std::string> warnings_;
};

}  // namespace

GltfScene readGltfScene(const json& document, ReadJob& job) {
    return SceneReader(document, job).read();
}

}  // namespace vestige
