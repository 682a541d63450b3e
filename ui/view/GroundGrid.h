#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include "core/pipeline/ViewRenderer.h"

class vtkActor;

namespace vestige {

/// A level grid of lines, every fifth stronger, hidden by what stands on it.
class GroundGrid {
  public:
    GroundGrid();
    ~GroundGrid();
    vtkActor& actor() { return *actor_; }

    /// Takes the ground's height and reach from the scene: the height that 5 % of its points lie below.
    void show(const ViewDescription& view, const Eigen::Vector3d& displayOrigin);
    /// Lines in the spacing of the picture round where the camera looks.
    void setCamera(const ViewCamera& camera);

  private:
    vtkSmartPointer<vtkActor> actor_;
    Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
    BoundingBox scene_;
    double height_ = 0;
    Theme theme_ = Theme::dark;
    bool on_ = false;
};

}  // namespace vestige
