#pragma once

#include <vtkNew.h>
#include <vtkOpenGLBufferObject.h>
#include <vtkOpenGLVertexArrayObject.h>
#include <vtkProp.h>
#include <vtkTimeStamp.h>

#include <array>
#include <vector>

#include "ui/view/PointBlocks.h"

class vtkShaderProgram;

namespace vestige {

using Rgba = std::array<std::uint8_t, 4>;

/// A point cloud in the VTK scene, drawn block by block straight from two vertex buffers (16 bytes a point;
/// vtkPolyData with vertex cells takes over 60). How much of each block a frame draws is set before it.
class PointProp : public vtkProp {
  public:
    static PointProp* New();
    using Superclass = vtkProp;

    /// Uploaded with the next frame and then dropped here.
    void setPositions(std::vector<Eigen::Vector3f> positions, std::vector<PointBlock> blocks,
                      double spacing_m);
    /// In the order of the positions.
    void setColors(std::vector<Rgba> colors);
    /// Points are drawn this large, and up to 2.5 times as large where they stand so far apart that a surface
    /// would be full of holes.
    void setPointSize(double pixels) { pointSize_ = pixels; }

    /// Draws the points as if they lay this much nearer to the camera: over what they coincide with.
    void setPull(double metres) { pull_m_ = metres; }

    /// Moves the points from where setPositions() has them, in the display frame.
    void setMotion(const Eigen::Matrix4f& motion) { motion_ = motion; }

    const std::vector<PointBlock>& blocks() const { return blocks_; }
    /// Which blocks the camera may see; as many as blocks().
    void setSeen(std::vector<bool> seen) { seen_ = std::move(seen); }
    /// The next frame draws this part of every seen block, as shares of its points.
    void setPart(double from, double to);

    double* GetBounds() override { return bounds_; }
    int RenderOpaqueGeometry(vtkViewport* viewport) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

  protected:
    PointProp() = default;
    ~PointProp() override = default;

  private:
    void upload();

    std::vector<Eigen::Vector3f> positions_;
    std::vector<Rgba> colors_;
    std::vector<PointBlock> blocks_;
    std::vector<bool> seen_;
    double from_ = 0;
    double to_ = 1;
    double pointSize_ = 2;
    double spacing_m_ = 0;
    double pull_m_ = 0;
    Eigen::Matrix4f motion_ = Eigen::Matrix4f::Identity();
    double bounds_[6] = {-1, 1, -1, 1, -1, 1};
    vtkNew<vtkOpenGLBufferObject> positionBuffer_;
    vtkNew<vtkOpenGLBufferObject> colorBuffer_;
    vtkNew<vtkOpenGLVertexArrayObject> arrays_;
    vtkShaderProgram* boundProgram_ = nullptr;
    bool attributesBound_ = false;
};

}  // namespace vestige
