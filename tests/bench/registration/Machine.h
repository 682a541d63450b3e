#pragma once

#include <string>

namespace vestige::bench {

/// Load average of the last minute.
double loadAverage();

/// Processor, cores, compiler, flags, versions and load: one Markdown list.
std::string describeMachine();

}  // namespace vestige::bench
