#pragma once

#include <QTimer>
#include <functional>
#include <memory>

#include "core/pipeline/ViewRenderer.h"
#include "ui/view/FrameBudget.h"
#include "ui/view/SceneDrawing.h"
#include "ui/view/ViewPanes.h"
#include "ui/view/ViewSurface.h"

namespace vestige {

/// Draws a view's panes frame by frame: each frame draws a part of one pane. The pane whose camera moves goes
/// first and is coarse; what stands still is completed bit by bit.
class PaneFrames {
  public:
    /// `drawn` is called after each frame.
    PaneFrames(std::unique_ptr<ViewSurface> surface, std::function<void()> drawn);
    ~PaneFrames();

    QWidget* widget() const { return surface_->widget(); }
    SceneDrawing& drawing() { return *drawing_; }
    ViewPanes& panes() { return panes_; }
    const ViewPanes& panes() const { return panes_; }

    /// After the description, the widget's size or the layout changed.
    void sceneChanged();
    void sizeChanged();
    void layoutChanged();
    /// After a pane's camera changed; after what all panes show changed.
    void paneChanged(ViewPane& pane);
    void allChanged();
    /// A pane, or all of them (null), move: frames are coarse until nothing did for a moment.
    void moves(const ViewPane* pane);
    /// How two pictures are mixed changed, no point did.
    void mixChanged();

    void completePicture();
    bool isComplete() const;
    double movingFrame_s() const { return movingFrame_s_; }

    /// The description to be drawn; set before sceneChanged().
    std::function<const ViewDescription&()> description;

  private:
    void start();
    void step(std::size_t pane, bool all);
    std::optional<std::size_t> nextPane() const;
    void frame();
    void rest();

    std::unique_ptr<ViewSurface> surface_;
    std::unique_ptr<SceneDrawing> drawing_;
    std::function<void()> drawn_;
    ViewPanes panes_;
    QTimer frameTimer_;  // the next frame, as soon as events are handled
    QTimer restTimer_;   // the camera stands still
    FrameBudget movingBudget_;
    FrameBudget restingBudget_;
    bool sceneChanged_ = true;
    bool moving_ = false;
    std::optional<std::size_t> movingPane_;  // nothing: all
    double movingFrame_s_ = 0;
};

}  // namespace vestige
