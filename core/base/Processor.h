#pragma once

#include <string>

namespace vestige {

/// The processor's own name for itself ("Intel(R) Core(TM) i7-12900K ..."), for reports that state times.
/// Empty where it gives none.
std::string processorName();

}  // namespace vestige
