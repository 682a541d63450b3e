#pragma once

#include <QObject>
#include <optional>

#include "core/pipeline/ViewRenderer.h"
#include "ui/shell/ResidualCache.h"

namespace vestige {

class Attempts;
class Comparison;
class Document;
class JobRunner;
class Presentation;
class Preview;
class SceneView;
class PointMarks;
struct Layer;
class Selection;

/// Keeps the view showing the document as presentation, preview and comparison ask.
class ScenePresenter : public QObject {
    Q_OBJECT

  public:
    /// What the view follows.
    struct Models {
        Document& document;
        Selection& selection;
        Presentation& presentation;
        const Preview& preview;
        const Comparison& comparison;
        const Attempts& attempts;
        PointMarks& marks;
    };
    ScenePresenter(const Models& models, JobRunner& jobs, SceneView& view, QObject* parent = nullptr);
    void showNamedView(NamedView view);
    /// Fills every pane with all that has its place, or with the section, seen from where its camera is.
    void showAll();
    /// World bounds of what has its place.
    BoundingBox placedBounds() const;
    /// Fills the view with the selected layer, else the one whose registration is described, seen from where
    /// the camera is.
    void showLayer();
    /// Fills the view with what was measured of the selected object and some room round it.
    void showObject();
    /// Fills the view with a box of the scene, seen from where the camera is.
    void showBox(const BoundingBox& box);
    /// Shows again what is selected and hidden.
    void refreshPoints();

  private:
    void chooseColors();
    ViewCamera framedAll(const ViewDescription& described, NamedView view) const;
    int roomAbove() const;
    void refresh();
    void refreshMarks();
    void computeResiduals();
    void show(ViewDescription described);
    bool isSource(const Layer& layer) const;
    void place(ViewLayer& shown) const;
    void annotate(ViewDescription& described) const;
    Overlay overlayNow() const;

    Models models_;
    ResidualCache residuals_;
    JobRunner& jobs_;
    SceneView& view_;
    std::optional<bool> ownColors_;  ///< whether a single scan was given its own; nothing: not decided yet
    bool frameAll_ = true;           ///< the next non-empty picture takes a camera that holds everything
    int refreshes_ = 0;  ///< residuals that were asked for before the last refresh are out of date
};

}  // namespace vestige
