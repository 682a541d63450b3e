#pragma once

#include <QObject>
#include <memory>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

/// A ViewRenderer for jobs: each picture is drawn by `renderer` on the thread that owns this object (VTK
/// draws on the GUI thread only), while the worker waits. A worker that is cancelled before its picture was
/// begun does not wait for it, so that a window that closes never blocks on a worker that waits for the
/// window.
class GuiThreadRenderer : public QObject, public ViewRenderer {
    Q_OBJECT

  public:
    explicit GuiThreadRenderer(ViewRenderer& renderer, QObject* parent = nullptr);
    Status renderPng(const ViewDescription& view, const std::filesystem::path& png,
                     const JobControl& control) override;

  private:
    ViewRenderer& renderer_;
};

}  // namespace vestige
