#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/pipeline/RegisterPair.h"
#include "core/scene/JointAdjustment.h"
#include "core/scene/Scene.h"

namespace vestige {

/// What the layers of a case were prepared with for their first pairs, or why they could not be.
using PreparedLayers = std::map<std::string, Result<PreparedRegistration>>;

struct RegisteredLayers {
    std::vector<std::pair<std::string, RegistrationResult>> layers;  ///< in the order of the case
    /// Where layers overlap each other or reach the target through each other; nothing where each stands by
    /// its own registration to the target, which is then registerLayer()'s, bit for bit.
    std::optional<JointAdjustment> adjustment;
};

/// One layer of attemptLayers().
struct AttemptedLayer {
    std::string id;
    /// A pose that can be relied on; or what the registration from the first pose found, with the verdict and
    /// the reasons; or why there is none.
    Result<RegistrationResult> result;
    std::optional<Error> failure;  ///< of a layer that no pair reaches
};
struct AttemptedLayers {
    std::vector<AttemptedLayer> layers;  ///< in the order of the case
    std::optional<JointAdjustment> adjustment;
};

/// Who watches the registrations of a layer; empty: nobody.
using LayerWatches = std::function<RegistrationWatch(const std::string& layer)>;

/// The layers that registerLayers() may prepare beforehand: those whose first pose is known in the target.
PreparedLayers prepareLayers(const SceneState& scene, const std::vector<std::string>& ids,
                             const JobControl& control);

/// Registers the loaded layers `ids` together: each to the target, or to the layer that its first pose names;
/// then to each other wherever they are expected to overlap; then all poses are adjusted with the pairs'
/// covariances, wrong pairs left out with the reason. A layer that is registered already and not among `ids`
/// stays where it is and serves the others. ErrorCode::untrustworthy names a layer that no pair reaches; a
/// pair that fails is no error while others reach its layers. Bit-identical for any thread count.
Result<RegisteredLayers> registerLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                        const JobControl& control);
/// The same, going on from prepareLayers(), which it uses up.
Result<RegisteredLayers> registerLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                        PreparedLayers prepared, const JobControl& control);

/// registerLayers() for those who show what was found: a layer that cannot be registered keeps none of the
/// others from it. Whoever enters a pose into the scene asks RegistrationResult::trustworthy() first. Steps
/// are told in the scene's frame.
Result<AttemptedLayers> attemptLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                      const JobControl& control, const LayerWatches& watches = {});

Result<AttemptedLayers> attemptLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                      PreparedLayers prepared, const JobControl& control,
                                      const LayerWatches& watches = {});

}  // namespace vestige
