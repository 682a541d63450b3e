#pragma once

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"
#include "core/registration/RegistrationResult.h"
#include "core/registration/RegistrationWatch.h"

namespace vestige {

/// method, preset, voxel_m (v_n), voxel_start_m (v0), leaf_m, outlier_ratio, ...: the `register` command, the
/// case's "registration" object and the window's form.
const ParameterTable& registrationParameters();

/// registerGeometry, but a pose that cannot be relied on is returned too, with the reasons why: for those who
/// show what was found.
Result<RegistrationResult> attemptRegistration(const TriangleMesh& target, const TriangleMesh& source,
                                               const Similarity& initial, const ParameterSet& parameters,
                                               const JobControl& control = {},
                                               const RegistrationWatch& watch = {});

/// Registers `source` (a cloud, or a mesh that is sampled) to `target`, starting from `initial`, whose scale
/// is the source's metres per unit and stays fixed. The target is in metres. Bit-identical for any thread
/// count. ErrorCode::untrustworthy when the clouds do not overlap from there or hold too few points.
Result<RegistrationResult> registerGeometry(const TriangleMesh& target, const TriangleMesh& source,
                                            const Similarity& initial, const ParameterSet& parameters,
                                            const JobControl& control = {},
                                            const RegistrationWatch& watch = {});

}  // namespace vestige
