#pragma once

#include <vtkNew.h>
#include <vtkRenderPass.h>
#include <vtkRenderStepsPass.h>

#include <Eigen/Core>
#include <memory>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace vestige {

/// Draws the scene into a picture that is kept from frame to frame, so that points can be added to it bit by
/// bit, and shows it with eye-dome lighting: a pixel is darkened by how far it lies behind its neighbours
/// (C. Boucheny, Visualisation scientifique interactive de grands volumes de donnees, 2009), depth measured
/// in pixel footprints, so that it looks alike in perspective and parallel views.
class PicturePass : public vtkRenderPass {
  public:
    static PicturePass* New();
    using Superclass = vtkRenderPass;

    /// The next frame begins an empty picture instead of adding to the last one.
    void restart() { empty_ = true; }
    void setEyeDomeLighting(bool on) { eyeDome_ = on; }
    void setBackground(const Eigen::Vector3f& top, const Eigen::Vector3f& bottom);

    void Render(const vtkRenderState* state) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

  protected:
    PicturePass();
    ~PicturePass() override;

  private:
    void fit(vtkOpenGLRenderWindow& window, int width, int height);
    void addProps(const vtkRenderState& state);
    void show(const vtkRenderState& state);

    vtkNew<vtkRenderStepsPass> steps_;
    vtkNew<vtkOpenGLFramebufferObject> framebuffer_;
    vtkNew<vtkTextureObject> color_;
    vtkNew<vtkTextureObject> depth_;
    std::unique_ptr<vtkOpenGLQuadHelper> quad_;
    Eigen::Vector3f top_ = {0.06F, 0.08F, 0.1F};
    Eigen::Vector3f bottom_ = {0.04F, 0.05F, 0.06F};
    int width_ = 0;
    int height_ = 0;
    bool empty_ = true;
    bool eyeDome_ = true;
};

}  // namespace vestige
