#pragma once

#include <string_view>
#include <vector>

#include "core/base/ParameterSet.h"
#include "core/base/Random.h"
#include "core/simulation/ModelBuilder.h"
#include "core/simulation/SurfaceModel.h"

namespace vestige {

/// A kind of object that a scene can hold: its parameters and how its surfaces are built.
struct ShapeKind {
    std::string_view name;
    const ParameterTable& (*parameters)();
    SurfaceModel (*build)(const ParameterSet&, Random&);
};

/// Every kind, in the order of the docs.
const std::vector<ShapeKind>& shapeKinds();
const ShapeKind* shapeKind(std::string_view name);

/// A length in metres as a parameter without a flag.
ParameterSpec sizeParameter(const char* key, const char* label, double value, double least, double most,
                            const char* help);
/// The choice of one material for a whole object.
ParameterSpec materialParameter(const char* value);

const ParameterTable& bicycleParameters();
SurfaceModel buildBicycle(const ParameterSet& parameters, Random& random);
const ParameterTable& boxParameters();
SurfaceModel buildBox(const ParameterSet& parameters, Random& random);
const ParameterTable& tripodParameters();
SurfaceModel buildTripod(const ParameterSet& parameters, Random& random);
const ParameterTable& groundParameters();
SurfaceModel buildGround(const ParameterSet& parameters, Random& random);
const ParameterTable& poleParameters();
SurfaceModel buildPole(const ParameterSet& parameters, Random& random);
const ParameterTable& treeParameters();
SurfaceModel buildTree(const ParameterSet& parameters, Random& random);

}  // namespace vestige
