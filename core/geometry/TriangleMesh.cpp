#include "core/geometry/TriangleMesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "core/base/Random.h"
#include "core/geometry/PointCloudBuilder.h"

namespace vestige {
namespace {

Eigen::Vector3d areaVector(const TriangleMesh& mesh, const Triangle& triangle) {
    const Eigen::Vector3d a = mesh.vertices.point(triangle[0]);
    return 0.5 * (mesh.vertices.point(triangle[1]) - a).cross(mesh.vertices.point(triangle[2]) - a);
}

}  // namespace

double surfaceArea(const TriangleMesh& mesh) {
    double area = 0;
    for (const Triangle& triangle : mesh.triangles) area += areaVector(mesh, triangle).norm();
    return area;
}

PointCloud sampleSurface(const TriangleMesh& mesh, double spacing, std::uint64_t seed) {
    if (!mesh.isMesh()) return mesh.vertices;
    PointCloudBuilder builder(mesh.vertices.origin());
    Random random(seed);
    // The fraction of a point that small triangles are due is carried on, so that the density holds for any
    // meshing.
    double due = random.uniform();
    for (const Triangle& triangle : mesh.triangles) {
        const Eigen::Vector3d area = areaVector(mesh, triangle);
        due += area.norm() / (spacing * spacing);
        if (due < 1) continue;
        const Eigen::Vector3d a = mesh.vertices.point(triangle[0]);
        const Eigen::Vector3d ab = mesh.vertices.point(triangle[1]) - a;
        const Eigen::Vector3d ac = mesh.vertices.point(triangle[2]) - a;
        const Eigen::Vector3f normal = area.normalized().cast<float>();
        for (; due >= 1; due -= 1) {
            double u = random.uniform();
            double v = random.uniform();
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            builder.add(a + u * ab + v * ac);
            builder.attributes().normal.push_back(normal);
        }
    }
    return std::move(builder).build();
}

}  // namespace vestige
