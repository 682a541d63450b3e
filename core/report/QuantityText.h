#pragma once

#include <optional>
#include <string>

#include "core/measurement/kinds/Quantity.h"
#include "core/scene/MeasuredKinds.h"

namespace vestige {

/// A figure as a reader sees it, with the digits that its uncertainty leaves: GUM 7.2.6, as for lengths
/// (MeasuredText.h). Without an uncertainty three decimals for metres, two for all else.

std::string quantityValueText(const QuantityStatistic& quantity);
/// "0.014"; an en dash without one.
std::string quantityUncertaintyText(const QuantityStatistic& quantity);
/// "58.9 to 71.2"; an en dash without one; "58.9 or more" where a straight line is not ruled out.
std::string quantityIntervalText(const QuantityStatistic& quantity);
/// "64.0 m ± 2.1 m"; of a figure whose interval is not symmetric "64.0 m (58.9 to 71.2 m)".
std::string quantitySentence(const QuantityStatistic& quantity);
/// Whether the interval is not symmetric about the mean.
bool isSkewed(const QuantityStatistic& quantity);

}  // namespace vestige
