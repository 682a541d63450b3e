#include "core/base/UnitWords.h"

#include "core/base/Numbers.h"
#include "core/base/Units.h"

namespace vestige {

std::string unitWords(double metresPerUnit) {
    const auto unit = lengthUnitOf(metresPerUnit);
    return unit ? std::string(nameOf(*unit)) : "units of " + exactText(metresPerUnit) + " m";
}

double exactUnit(double metresPerUnit) {
    const auto unit = lengthUnitOf(metresPerUnit);
    return unit ? metresPer(*unit) : metresPerUnit;
}

}  // namespace vestige
