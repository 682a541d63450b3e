#pragma once

#include "core/base/ParameterSet.h"
#include "core/filters/Ground.h"
#include "core/filters/Objects.h"
#include "core/filters/Outliers.h"

namespace vestige {

/// Of a lasso or box: which side of it is taken, how deep, of which layers.
const ParameterTable& outlineParameters();
/// Of the outliers to take out of the scene; those of the preprocessing are for registration alone.
const ParameterTable& outlierSearchParameters();
const ParameterTable& groundSearchParameters();
const ParameterTable& objectSearchParameters();

/// Lengths in the unit of the cloud, of `metresPerUnit`.
OutlierOptions outlierOptions(const ParameterSet& parameters, double metresPerUnit);
GroundOptions groundOptions(const ParameterSet& parameters);
ObjectOptions objectOptions(const ParameterSet& parameters);

/// All values, as people read them: "Outliers: sor; Neighbours (sor): 8".
std::string describe(const ParameterSet& parameters);

}  // namespace vestige
