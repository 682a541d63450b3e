#pragma once

#include "core/base/ParameterSet.h"
#include "core/base/Random.h"
#include "core/simulation/ModelBuilder.h"
#include "core/simulation/shapes/CarShape.h"
#include "core/simulation/shapes/Shapes.h"

namespace vestige {

/// A saloon car with open windows' glass, seats, wheels, mirrors, handles and lamps. Parameters:
/// carParameters.
SurfaceModel buildCar(const ParameterSet& parameters, Random& random);
const ParameterTable& carParameters();

/// Its pieces, one file each.
void addCarBody(ModelBuilder& builder, const CarShape& shape);
void addCarCabin(ModelBuilder& builder, const CarShape& shape);
void addCarInterior(ModelBuilder& builder, const CarShape& shape);
void addCarWheels(ModelBuilder& builder, const CarShape& shape);
void addCarMirrors(ModelBuilder& builder, const CarShape& shape);
void addCarHandles(ModelBuilder& builder, const CarShape& shape);

}  // namespace vestige
