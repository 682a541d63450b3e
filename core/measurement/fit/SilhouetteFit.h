#pragma once

#include <optional>

#include "core/measurement/fit/EdgeFit.h"

namespace vestige {

/// Where a plane's points end beside `about`, from the beams that see that end sharply: those that pass along
/// it, whose noise and long side of the spot have little part across the edge. Maximum likelihood of a
/// density that is even inside and ends at the edge, each point blurred by its own beam; a point weighs as
/// much as the share of its spot that met the surface. The beams of either side of the site are
/// read apart and averaged. The line keeps the direction of `about`. Nothing where
/// the scanner's path is not known or too few beams pass along the edge.
std::optional<LineFit> silhouetteOf(const Neighbourhood& near, const PlaneFit& plane, const LineFit& about);

}  // namespace vestige
