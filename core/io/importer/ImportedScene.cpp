#include "core/io/importer/ImportedScene.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/PointCloudBuilder.h"
#include "core/io/PointSink.h"

namespace vestige {
namespace {

constexpr Color kWhite{65535, 65535, 65535};

class SceneAssembly {
  public:
    SceneAssembly(const ImportedScene& scene, ReadJob& job) : scene_(scene), job_(job) {}

    TriangleMesh build(std::uint64_t mostVertices) {
        checkMeshes();
        count(mostVertices);
        builder_.reserve(vertices_);
        triangles_.reserve(triangleCount_);
        for (const ImportedInstance& instance : scene_.instances) add(instance);
        return {std::move(builder_).build(), std::move(triangles_)};
    }

  private:
    void checkMeshes() const {
        for (const ImportedMesh& mesh : scene_.meshes)
            for (const Triangle& triangle : mesh.triangles)
                for (const std::uint32_t corner : triangle)
                    if (corner >= mesh.vertices.size())
                        job_.refuse("a triangle names vertex " + std::to_string(corner) + " of a mesh",
                                    counted(mesh.vertices.size(), "vertex") + ", counted from 0");
    }

    void count(std::uint64_t mostVertices) {
        std::size_t colored = 0, withNormals = 0;
        mostVertices = std::min<std::uint64_t>(mostVertices, std::numeric_limits<std::uint32_t>::max());
        for (const ImportedInstance& instance : scene_.instances) {
            if (instance.mesh >= scene_.meshes.size())
                job_.refuse("an object names a mesh that is not there",
                            counted(scene_.meshes.size(), "mesh") + ", counted from 0");
            if (!instance.fileFromMesh.matrix().allFinite())
                job_.refuse("the place of an object is no finite number", "finite numbers");
            const ImportedMesh& mesh = scene_.meshes[instance.mesh];
            vertices_ += mesh.vertices.size();
            triangleCount_ += mesh.triangles.size();
            refuseMoreThan(mostVertices, vertices_, "vertices");
            refuseMoreThan(kTrianglesOfVertex * mostVertices, triangleCount_, "triangles");
            if (!mesh.colors.empty()) colored += mesh.vertices.size();
            if (!mesh.normals.empty()) withNormals += mesh.vertices.size();
        }
        keepColors_ = colored > 0;
        keepNormals_ = withNormals > 0;
        if (keepColors_ && colored < vertices_)
            job_.warn(counted(vertices_ - colored, "vertex") + " of objects without colours are white");
    }

    void refuseMoreThan(std::uint64_t most, std::uint64_t count, const std::string& what) const {
        if (count > most)
            job_.refuse(
                "the file repeats its objects until they have more than " + std::to_string(most) + " " + what,
                "no more than that for a file of its size");
    }

    void add(const ImportedInstance& instance) {
        const ImportedMesh& mesh = scene_.meshes[instance.mesh];
        const auto first = static_cast<std::uint32_t>(builder_.size());
        for (const Eigen::Vector3d& vertex : mesh.vertices) {
            job_.step(builder_.size(), vertices_);
            builder_.add(instance.fileFromMesh * vertex);
        }
        PointAttributes& attributes = builder_.attributes();
        attributes.color.insert(attributes.color.end(), mesh.colors.begin(), mesh.colors.end());
        if (keepColors_) attributes.color.resize(builder_.size(), kWhite);
        const Eigen::Matrix3d linear = instance.fileFromMesh.linear();
        const Eigen::Matrix3d turn = cofactors(linear);
        for (const Eigen::Vector3f& normal : mesh.normals)
            attributes.normal.push_back(cleanNormal(turn * normal.cast<double>()));
        if (keepNormals_) attributes.normal.resize(builder_.size(), Eigen::Vector3f::Zero());
        const bool mirrored = linear.determinant() < 0;
        for (Triangle triangle : mesh.triangles) {
            for (std::uint32_t& corner : triangle) corner += first;
            if (mirrored) std::swap(triangle[1], triangle[2]);
            triangles_.push_back(triangle);
        }
    }

    /// The inverse transposed up to a positive factor, which also exists where the matrix has no inverse.
    static Eigen::Matrix3d cofactors(const Eigen::Matrix3d& m) {
        Eigen::Matrix3d result;
        for (int i = 0; i < 3; ++i) result.col(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3));
        return m.determinant() < 0 ? Eigen::Matrix3d(-result) : result;
    }

    const ImportedScene& scene_;
    ReadJob& job_;
    PointCloudBuilder builder_;
    std::vector<Triangle> triangles_;
    std::uint64_t vertices_ = 0, triangleCount_ = 0;
    bool keepColors_ = false, keepNormals_ = false;
};

}  // namespace

TriangleMesh assembleScene(ImportedScene scene, std::uint64_t mostVertices, ReadJob& job) {
    for (std::string& warning : scene.warnings) job.warn(std::move(warning));
    return SceneAssembly(scene, job).build(mostVertices);
}

}  // namespace vestige
