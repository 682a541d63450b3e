#pragma once

#include <QObject>

#include "core/pipeline/ViewRenderer.h"

namespace vestige {

class Document;
class JobRunner;
class Presentation;
class SceneView;
class Selection;

/// Keeps the view showing the document as the presentation asks.
class ScenePresenter : public QObject {
    Q_OBJECT

  public:
    ScenePresenter(Document& document, Selection& selection, Presentation& presentation, JobRunner& jobs,
                   SceneView& view, QObject* parent = nullptr);
    void showNamedView(NamedView view);

  private:
    void refresh();
    void refreshMarks();
    void computeResiduals();
    void show(ViewDescription described);

    Document& document_;
    Selection& selection_;
    Presentation& presentation_;
    JobRunner& jobs_;
    SceneView& view_;
    bool frameAll_ = true;  ///< the next non-empty picture takes a camera that holds everything
    int refreshes_ = 0;     ///< residuals that were asked for before the last refresh are out of date
};

}  // namespace vestige
