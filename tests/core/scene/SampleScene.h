#pragma once

#include <string>

#include "core/scene/Scene.h"

namespace vestige::test {

/// Three layers (aerial target, handheld in millimetres registered to it, photogrammetry on its own), two
/// measurements with picks of every form, aims, views and parameters that are not the defaults.
SceneState sampleScene();

/// A layer of that id with everything a case gives.
Layer sampleLayer(const std::string& id, LayerRole role);

RegistrationResult sampleResult(double shift_m, double angle_rad);

/// Equal as documents, in loaded data and in the file.
bool equal(const SceneState& a, const SceneState& b);

}  // namespace vestige::test
