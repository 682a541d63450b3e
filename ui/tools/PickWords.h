#pragma once

#include <QString>
#include <optional>

#include "ui/tools/PickHandles.h"
#include "ui/tools/ProbedPlace.h"

namespace vestige {

struct MeasuredScene;

/// "edge, σ 0.4 mm", "point, spacing 6 mm", "no edge here": of the loupe. The uncertainty is the standard one
/// of the place along its worst direction.
QString captionOf(const ProbedPlace& place);

/// "0.4 mm", "14 mm": two digits.
QString millimetreText(double metres);

/// What the repeats of the selected object say of each other so far: their mean and standard deviation, and
/// how far `last` is from the mean of the others. Empty without repeats.
QString repeatNoiseText(const SceneState& scene, const Selection& selection,
                        const std::optional<PickHandle>& last);

/// The same of the main figure of the selected object, in its unit.
QString figureNoiseText(const MeasuredScene& measured, const Selection& selection);

}  // namespace vestige
