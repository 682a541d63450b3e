#pragma once

#include <limits>
#include <vector>

#include "core/registration/ndt/NormalDistributions.h"

namespace vestige {

/// start, factor start, factor^2 start, ... down to `finest`, which always ends the list.
std::vector<double> voxelSchedule(double start, double finest, double factor);

/// Which of the schedule's sizes v_n is (METHOD section 3, step 2): a size counts while at least half of the
/// target's points lie in voting cells; among sizes within 0.01 of the largest flatness ratio, the smallest.
/// `counts` runs from the largest size to the smallest; the largest size where none counts. Returns an index.
/// `leastShare` stands in for the half. Sizes above `ceiling` are chosen only where no smaller one counts.
std::size_t finestByFlatness(const std::vector<FlatnessCount>& counts, std::size_t targetPoints,
                             double ceiling = std::numeric_limits<double>::infinity(),
                             double leastShare = 0.5);

/// Whether the last size no longer counts and one before did: smaller ones need no look.
bool pastLeastShare(const std::vector<FlatnessCount>& counts, std::size_t targetPoints,
                    double leastShare = 0.5);

}  // namespace vestige
