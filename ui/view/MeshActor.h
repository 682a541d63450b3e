#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/TriangleMesh.h"

class vtkActor;

namespace vestige {

/// A lit surface in the VTK scene; both sides are shown. Positions become floats round `displayOrigin`.
vtkSmartPointer<vtkActor> makeMeshActor(const TriangleMesh& mesh, const Similarity& worldFromLayer,
                                        const Eigen::Vector3d& displayOrigin);

/// The triangles that are drawn: those none of whose corners is hidden (not 0); null: all.
void setTriangles(vtkActor& actor, const TriangleMesh& mesh, const std::vector<std::uint8_t>* hidden);

/// The mapper's clipping planes cut away what lies within all of them, instead of the rest.
void setInverted(vtkActor& actor, bool inverted);

/// One colour per vertex, by its index.
void setVertexColors(vtkActor& actor, const std::vector<std::array<std::uint8_t, 4>>& colors);

}  // namespace vestige
