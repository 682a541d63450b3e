#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/ViewRenderer.h"
#include "core/scene/Scene.h"

namespace vestige {

/// Distances to the target that were computed: they depend on two clouds and where these lie, so an edit of
/// anything else needs no computing again.
class ResidualCache {
  public:
    /// Of a description with distances, as it was computed from the scene.
    void remember(const ViewDescription& described, const SceneState& scene);
    /// Makes the description one with distances; false, and nothing is changed, where some are not known.
    bool fill(ViewDescription& described, const SceneState& scene) const;
    void clear() { known_.clear(); }

  private:
    struct Known {
        std::weak_ptr<const TriangleMesh> cloud;
        std::weak_ptr<const LayerData> target;
        Similarity place;
        Similarity targetPlace;
        std::shared_ptr<const std::vector<float>> distances;
    };
    std::map<std::string, Known> known_;  ///< by layer id
};

}  // namespace vestige
