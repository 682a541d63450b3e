#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "core/geometry/BoundingBox.h"
#include "ui/actions/Workbench.h"
#include "ui/document/PointSelection.h"

namespace vestige {

struct Layer;

/// Takes selected points out of the scene and back, finds outliers, the ground and what stands on it, and
/// makes objects; every change is one step of the history, and no file is touched.
class CleaningReactions : public QObject {
    Q_OBJECT

  public:
    explicit CleaningReactions(const Workbench& bench, QObject* parent = nullptr);

  signals:
    /// An object was made of the selection; its name wants editing.
    void objectMade(const std::string& name);
    /// World, metres.
    void boxWanted(const vestige::BoundingBox& box);

  private:
    void removeSelected();
    void keepSelected();
    void takeOut(const PointSelection::Sets& sets, const std::string& how, const std::string& parameters);
    void bringBack();
    void makeObject();
    void findOutliers();
    void findGround();
    void separateObjects();
    void selectObject();
    void lookAtObject();
    std::vector<Layer> layersToSearch() const;
    const Layer* layerToSeparate() const;
    void tellNothing();

    Workbench bench_;
};

}  // namespace vestige
