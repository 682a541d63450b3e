#pragma once

#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/scene/Scene.h"
#include "ui/document/PointSelection.h"

namespace vestige {

/// What cleaning does on the worker's thread: from layers that are loaded to points and objects of them. The
/// parameter sets are those of core/filters/CleaningParameters.h.

Result<PointSelection::Sets> outliersOf(const std::vector<Layer>& layers, const ParameterSet& settings,
                                        const JobControl& control);
Result<PointSelection::Sets> groundOf(const Layer& layer, const ParameterSet& settings,
                                      const JobControl& control);
/// Without names.
Result<std::vector<SceneObject>> objectsOf(const Layer& layer, const ParameterSet& ground,
                                           const ParameterSet& settings, const JobControl& control);
/// Points (as loaded) of a layer as an object without a name.
SceneObject objectFrom(const Layer& layer, const std::shared_ptr<const PointSet>& points, std::string found);
/// Where they lie in the scene, m.
BoundingBox boundsOf(const Layer& layer, const PointSet& points);
/// "Vehicle", "Debris", ...: what objects of a kind are called with a number.
std::string nameOfKind(const std::string& kind);

}  // namespace vestige
