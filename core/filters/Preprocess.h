#pragma once

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"
#include "core/geometry/PointCloud.h"

namespace vestige {

/// filter, radius_m, voxel_m, representative, outliers and the outliers' own: the `preprocess` command, the
/// case file's "preprocess" object and the window's form. voxel_m automatic: no downsampling.
const ParameterTable& preprocessParameters();

/// `parameters` with an automatic radius_m replaced by the one that `cloud` asks for (3 times its median
/// spacing), which also goes out as a message; as they are when no radius is needed. For those who report
/// what was chosen; preprocess() does it by itself.
ParameterSet withChosenRadius(const PointCloud& cloud, const ParameterSet& parameters,
                              double metresPerUnit = 1, const JobControl& control = {});

/// Outliers, then the neighbourhood filter, then voxels (METHOD section 2), lengths in metres, the cloud in
/// `metresPerUnit`.
Result<PointCloud> preprocess(const PointCloud& cloud, const ParameterSet& parameters,
                              double metresPerUnit = 1, const JobControl& control = {});

}  // namespace vestige
