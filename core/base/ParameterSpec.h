#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vestige {

enum class ParameterType { boolean, integer, real, choice, text };

/// A parameter's value. std::monostate means "automatic": the program chooses and says what it chose.
using ParameterValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// Everything there is to say about one parameter, said once: the command line, the forms of the window, the
/// case file and the report all read it here.
struct ParameterSpec {
    std::string key;    ///< name in the case file and in parameter sets, with its unit: "voxel_m"
    std::string flag;   ///< name on the command line without dashes: "voxel"; empty when it has none
    std::string label;  ///< name for people: "Smallest voxel"
    std::string unit;   ///< "m", "deg", "px", ...; empty for plain numbers
    ParameterType type = ParameterType::real;
    ParameterValue defaultValue;
    std::optional<double> minimum;  ///< inclusive; integer and real only
    std::optional<double> maximum;  ///< inclusive; integer and real only
    std::vector<std::string> choices;
    std::string help;  ///< one sentence

    bool mayBeAutomatic() const { return std::holds_alternative<std::monostate>(defaultValue); }
};

using ParameterTable = std::vector<ParameterSpec>;

}  // namespace vestige
