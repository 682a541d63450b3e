#pragma once

#include <vtkNew.h>
#include <vtkRenderPass.h>
#include <vtkRenderStepsPass.h>

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkTextureObject;

namespace vestige {

/// Draws the scene into a picture that is kept from frame to frame, so that points can be added to it bit by
/// bit, and shows it with eye-dome lighting: a pixel is darkened by how far it lies behind its neighbours
/// (C. Boucheny, Visualisation scientifique interactive de grands volumes de donnees, 2009), depth measured
/// in pixel footprints, so that it looks alike in perspective and parallel views. For a comparison it keeps
/// two such pictures and lays them into each other when it shows them, so that moving the divider draws no
/// point again.
class PicturePass : public vtkRenderPass {
  public:
    static PicturePass* New();
    using Superclass = vtkRenderPass;

    /// The next frame begins an empty picture instead of adding to the last one.
    void restart() { empty_ = true; }
    void setEyeDomeLighting(bool on) { eyeDome_ = on; }
    /// Before a prop is drawn into a picture (0: the scene, 1: the other one of a comparison): moves it to
    /// where it lies there; false when it has no place in that picture.
    using Prepare = std::function<bool(vtkProp& prop, int picture)>;
    void setPrepare(Prepare prepare) { prepare_ = std::move(prepare); }
    /// How the two pictures are shown; the frame after one that had none, or has none, must restart().
    enum class Mix { none, own, swipe, checkerboard, other };
    void setMix(Mix mix, float divider, int tile_px);
    bool compares() const { return mix_ != Mix::none; }
    /// Called when the window's graphics resources are given back, with its context current, for what the
    /// props have together.
    void setRelease(std::function<void()> release) { release_ = std::move(release); }
    /// From the top of the window to its bottom; `transparent`: none, and the picture says where nothing is.
    void setBackground(const Eigen::Vector3f& top, const Eigen::Vector3f& bottom, bool transparent = false);
    /// The picture is a part of a larger one: where its lower and upper edge lie in that, as shares of its
    /// height.
    void setBand(float low, float high);

    void Render(const vtkRenderState* state) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

  protected:
    PicturePass();
    ~PicturePass() override;

  private:
    void fit(vtkOpenGLRenderWindow& window, int width, int height);
    struct Picture {
        vtkNew<vtkTextureObject> color;
        vtkNew<vtkTextureObject> depth;
        void fit(vtkOpenGLRenderWindow& window, int width, int height);
    };
    void addProps(const vtkRenderState& state, int index);
    void show(const vtkRenderState& state, int left, int low);

    vtkNew<vtkRenderStepsPass> steps_;
    vtkNew<vtkOpenGLFramebufferObject> framebuffer_;
    std::array<Picture, 2> pictures_;
    Prepare prepare_;
    std::function<void()> release_;
    Mix mix_ = Mix::none;
    float divider_ = 0.5F;
    int tile_px_ = 96;
    std::unique_ptr<vtkOpenGLQuadHelper> quad_;
    Eigen::Vector3f top_ = {0.06F, 0.08F, 0.1F};
    Eigen::Vector3f bottom_ = {0.04F, 0.05F, 0.06F};
    float bandLow_ = 0;
    float bandHigh_ = 1;
    bool transparent_ = false;
    int width_ = 0;
    int height_ = 0;
    bool empty_ = true;
    bool bothDrawn_ = false;  ///< the last frames drew the other picture, too
    bool eyeDome_ = true;
};

}  // namespace vestige
