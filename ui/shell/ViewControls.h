#pragma once

#include <QObject>
#include <optional>

#include "core/geometry/SectionSlab.h"
#include "ui/actions/Workbench.h"
#include "ui/tools/SectionTool.h"

namespace vestige {

class ScenePresenter;
class SceneView;
class ViewArea;
class ViewsPanel;

/// The actions that turn the view, divide it, cut the scene and keep views: those that need the view itself.
class ViewControls : public QObject {
    Q_OBJECT

  public:
    ViewControls(const Workbench& bench, SceneView& view, ScenePresenter& presenter,
                 QObject* parent = nullptr);
    ~ViewControls() override;

    /// Puts the bars of section, colours and picture over the view, and listens to the panel.
    void attach(ViewArea& area, ViewsPanel& panel);

  private:
    void connectCameras();
    void connectSection();
    void connectMouse();
    void cutTo(SlabAxis axis);
    void saveView(const QString& name);
    void goTo(const QString& name);

    Workbench bench_;
    SceneView& view_;
    ScenePresenter& presenter_;
    SectionTool section_;
    std::optional<SectionBox> lastSection_;  ///< comes back when the section is switched on again
    ViewsPanel* panel_ = nullptr;
};

}  // namespace vestige
