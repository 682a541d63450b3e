#pragma once

#include "core/base/Result.h"
#include "core/registration/RegistrationFrame.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/RegistrationWatch.h"
#include "core/registration/ndt/TrustRegion.h"

namespace vestige {

/// A cloud with fewer points cannot be registered.
inline constexpr std::size_t kFewestPoints = 10;
/// ErrorCode::untrustworthy when the target or the thinned source has too few points; ErrorCode::usage when
/// cells of edge `cell_m` are too small to be counted across the clouds.
Status checkTarget(const RegistrationFrame& frame, double cell_m);
Status checkSource(const CentredSource& source);

/// A registration on its way through its levels: keeps the pose and the record, tells the watch.
class Descent {
  public:
    /// `frame` and `watch` must outlive it; `levels` is how many there will be.
    Descent(const RegistrationFrame& frame, const Similarity& initial, const RegistrationWatch& watch,
            int levels);

    /// The pose so far, for this thinning of the source.
    Pose local(const CentredSource& source) const;
    /// Hands the iterations of the next level on to whoever watches; empty when nobody does.
    TrustRegionWatch observer(const CentredSource& source, double voxel) const;
    /// What a level ended with.
    void record(const TrustRegionOutcome& outcome, const CentredSource& source, double voxel);
    RegistrationResult& result() { return result_; }

  private:
    const RegistrationFrame& frame_;
    const RegistrationWatch& watch_;
    int levels_;
    RegistrationResult result_;
};

}  // namespace vestige
