#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/measurement/MeasurementKind.h"
#include "core/measurement/kinds/KindInput.h"

namespace vestige {

/// Everything there is to say about a kind of measurement, said once: window, case file and report read it
/// here.
struct KindSpec {
    MeasurementKind kind;
    std::string label;       ///< "Arc (yaw mark)"
    std::string meaning;     ///< one sentence: what it is, for tool tips and the report
    std::size_t fewest = 2;  ///< picks of one repeat
    std::size_t most = 2;    ///< 0: any number
    /// What the pick of that place is, the last one for all that follow: "the vertex".
    std::vector<std::string> picks;
    bool isLength = true;       ///< its main figure is a length with a tape: a row of measurements.csv
    bool usesVertical = false;  ///< depends on which way is up, not on distances alone
    bool usesCloud = false;     ///< looks at the points round the picks
    const ParameterTable* parameters = nullptr;
    EvaluateKind evaluate = nullptr;

    bool isPair() const { return fewest == 2 && most == 2; }
    const std::string& pickName(std::size_t place) const;
};

/// What the pick of that place is for an object with these settings: a plane may have more points than three.
const std::string& pickName(const KindSpec& spec, const std::map<std::string, double>& settings,
                            std::size_t place);
/// What to know while picking the kind; empty for most.
std::string pickAdvice(const KindSpec& spec, const std::map<std::string, double>& settings);

const std::vector<KindSpec>& kindTable();
const KindSpec& kindSpec(MeasurementKind kind);

/// The kind's parameters with the values of a case; ErrorCode::input that names the parameter and what is
/// allowed where one is unknown or out of range.
Result<ParameterSet> kindSettings(MeasurementKind kind, const std::map<std::string, double>& values);

}  // namespace vestige
