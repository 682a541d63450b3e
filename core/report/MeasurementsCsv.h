#pragma once

#include <string>

#include "core/scene/MeasuredScene.h"

namespace vestige {

/// measurements.csv: a row per object and method, numbers exact, empty where there is none. More than three
/// repeats stand in further columns `measured_4_m` ... behind the others.
std::string measurementsCsv(const MeasuredScene& measured);

}  // namespace vestige
