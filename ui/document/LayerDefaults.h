#pragma once

#include <string>
#include <vector>

#include "core/scene/Scene.h"

namespace vestige {

/// What a layer gets when files are opened without a case.

/// Ids and names from the file names (unique in `scene` and among themselves), role and method: the first
/// layer of a case and LAS files are aerial, the others handheld; and tints that can be told apart.
void nameLayers(std::vector<Layer>& layers, const SceneState& scene);

/// A tint of its own for each layer that has the one every layer begins with.
void tintApart(std::vector<Layer>& layers);

/// Sets the unit of layers that are to be registered where it is recognised from their size; a sentence for
/// the user for each that is not in metres.
std::vector<std::string> recogniseUnits(std::vector<Layer>& layers, const SceneState& scene);

}  // namespace vestige
