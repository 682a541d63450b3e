#pragma once

#include <QObject>
#include <memory>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

class SteppedRenderer;

/// A ViewRenderer for jobs: each picture is drawn by `renderer` on the thread that owns this object (VTK
/// draws on the GUI thread only), step by step where the renderer can, while the worker waits and the window
/// handles events between the steps. The worker packs and writes the file. A worker that is cancelled does
/// not wait, so that a window that closes never blocks on a worker that waits for the window.
class GuiThreadRenderer : public QObject, public ViewRenderer {
    Q_OBJECT

  public:
    explicit GuiThreadRenderer(ViewRenderer& renderer, QObject* parent = nullptr);
    Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                     const JobControl& control) override;
    std::string version() const override { return renderer_.version(); }

  private:
    struct Picture;
    void begin(const std::shared_ptr<Picture>& picture);
    void step(const std::shared_ptr<Picture>& picture);

    ViewRenderer& renderer_;
    SteppedRenderer* steps_;  ///< the same; null where it draws in one step only
};

}  // namespace vestige
