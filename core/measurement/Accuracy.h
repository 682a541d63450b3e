#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vestige {

/// One object measured by one method; `measured_m` is empty when the method could not measure it.
struct AccuracyObject {
    std::string object;
    double tape_m = 0;
    std::optional<double> measured_m;
    std::optional<double> re;  ///< fraction, signed, never rounded
    bool excluded = false;
    bool small = false;  ///< smaller than three spots of the beam that measured it
};

/// RMSE with outlier exclusion (METHOD section 5) of one method.
struct MethodAccuracy {
    std::string name;
    std::size_t n = 0;           ///< measured objects
    std::optional<double> sd;    ///< sample SD of the signed RE; none below two objects
    std::optional<double> rmse;  ///< of the objects that are not excluded
    std::optional<double> rmseAll;
    std::optional<double> rmseLarge;       ///< of all that are not small
    std::optional<double> rmseAbsolute_m;  ///< RMSE of the absolute errors of all measured objects, metres
    bool systematic = false;  ///< the rule would have excluded half or more, so nothing was excluded
    double meanRe = 0;
    std::vector<std::string> excluded;
    std::vector<std::string> small;  ///< measured, but smaller than three spots of the beam
    std::vector<AccuracyObject> objects;
};

/// Fills RE, exclusion and the statistics.
MethodAccuracy methodAccuracy(std::string name, std::span<const AccuracyObject> objects);

}  // namespace vestige
