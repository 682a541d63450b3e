#pragma once

#include <string>

namespace vestige {

/// "metres", "US survey feet"; "units of 0.3047972654 m" for a length that is none of ours. For sentences.
std::string unitWords(double metresPerUnit);

/// The exact length of the unit that is meant (see lengthUnitOf()); of any other length that itself.
double exactUnit(double metresPerUnit);

}  // namespace vestige
