#pragma once

#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/scene/KindRepeats.h"

namespace vestige {

/// While one of these lives, what this thread measures asks no clouds: figures of kinds that look at them
/// (cross-sections, volumes) are taken where they are remembered, and else left to computeCloudKinds, with a
/// note in their place that tells of it. Of scopes within each other the innermost counts.
class CloudKindsLater {
  public:
    /// `givenUp`: nobody computes them for now, and the note says so.
    explicit CloudKindsLater(bool givenUp = false);
    ~CloudKindsLater();
    CloudKindsLater(const CloudKindsLater&) = delete;
    CloudKindsLater& operator=(const CloudKindsLater&) = delete;

    /// What was left so far.
    const std::vector<KindRepeats>& missing() const { return missing_; }

    /// Of this thread; null outside of all scopes.
    static CloudKindsLater* current();
    KindOutcome leave(KindRepeats repeats);

  private:
    bool givenUp_;
    std::vector<KindRepeats> missing_;
    CloudKindsLater* outer_;
};

/// Computes what was left, of the same scene; measuring it finds the figures remembered from then on. Stops
/// between two evaluations of a kind once `control` is cancelled.
Status computeCloudKinds(const SceneState& scene, const std::vector<KindRepeats>& missing,
                         const JobControl& control);

}  // namespace vestige
