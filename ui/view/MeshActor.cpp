#include "ui/view/MeshActor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace vestige {
namespace {

vtkNew<vtkFloatArray> floatTuples(const std::vector<Eigen::Vector3f>& values) {
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    if (!values.empty()) std::copy_n(values.front().data(), 3 * values.size(), array->GetPointer(0));
    return array;
}

/// Mean of the triangles' normals round each vertex, by area.
std::vector<Eigen::Vector3f> vertexNormals(const std::vector<Eigen::Vector3f>& places,
                                           const std::vector<Triangle>& triangles) {
    std::vector<Eigen::Vector3f> normals(places.size(), Eigen::Vector3f::Zero());
    for (const Triangle& t : triangles) {
        const Eigen::Vector3f normal = (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]);
        for (const std::uint32_t corner : t) normals[corner] += normal;
    }
    for (Eigen::Vector3f& normal : normals) normal.normalize();
    return normals;
}

}  // namespace

vtkSmartPointer<vtkActor> makeMeshActor(const TriangleMesh& mesh, const Similarity& worldFromLayer,
                                        const Eigen::Vector3d& displayOrigin) {
    std::vector<Eigen::Vector3f> places(mesh.vertices.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = (worldFromLayer * mesh.vertices.point(i) - displayOrigin).cast<float>();

    vtkNew<vtkPoints> points;
    points->SetData(floatTuples(places));
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->GetPointData()->SetNormals(floatTuples(vertexNormals(places, mesh.triangles)));

    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->SetScalarModeToUsePointData();
    mapper->SetColorModeToDirectScalars();
    mapper->StaticOn();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(0.25);
    actor->GetProperty()->SetDiffuse(0.8);
    actor->GetProperty()->SetSpecular(0.05);
    return actor;
}

void setTriangles(vtkActor& actor, const TriangleMesh& mesh, const std::vector<std::uint8_t>* hidden) {
    const auto isHidden = [&](std::uint32_t corner) {
        return hidden && corner < hidden->size() && (*hidden)[corner] != 0;
    };
    vtkNew<vtkCellArray> cells;
    cells->AllocateEstimate(static_cast<vtkIdType>(mesh.triangles.size()), 3);
    for (const Triangle& triangle : mesh.triangles)
        if (std::none_of(triangle.begin(), triangle.end(), isHidden))
            cells->InsertNextCell({static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
                                   static_cast<vtkIdType>(triangle[2])});
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
    mapper->GetInput()->SetPolys(cells);
    mapper->Modified();
}

void setInverted(vtkActor& actor, bool inverted) {
    // The mapper's own text has a fragment go that is outside of any plane.
    vtkShaderProperty* shader = actor.GetShaderProperty();
    if ((shader->GetNumberOfShaderReplacements() > 0) == inverted) return;
    shader->ClearAllFragmentShaderReplacements();
    if (!inverted) return;
    shader->AddFragmentShaderReplacement("//VTK::Clip::Impl", true, R"(
  bool cutAway = true;
  for (int planeNum = 0; planeNum < numClipPlanes; planeNum++)
    if (clipDistancesVSOutput[planeNum] < 0.0) cutAway = false;
  if (cutAway) discard;
)",
                                         true);
}

void setVertexColors(vtkActor& actor, const std::vector<std::array<std::uint8_t, 4>>& colors) {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(colors.size()));
    unsigned char* next = array->GetPointer(0);
    for (const auto& color : colors) next = std::copy_n(color.data(), 3, next);
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
    vtkPolyData* surface = mapper->GetInput();
    surface->GetPointData()->SetScalars(array);
    surface->Modified();
    mapper->Modified();
}

}  // namespace vestige
