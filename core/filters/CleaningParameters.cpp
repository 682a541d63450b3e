#include "core/filters/CleaningParameters.h"

namespace vestige {
namespace {

ParameterSpec choiceOf(const char* key, const char* label, const char* standard,
                       std::vector<std::string> choices, const char* help) {
    ParameterSpec spec;
    spec.key = key;
    spec.label = label;
    spec.type = ParameterType::choice;
    spec.defaultValue = std::string(standard);
    spec.choices = std::move(choices);
    spec.help = help;
    return spec;
}

ParameterSpec numberOf(const char* key, const char* label, const char* unit, ParameterType type,
                       ParameterValue standard, double minimum, double maximum, const char* help) {
    ParameterSpec spec;
    spec.key = key;
    spec.label = label;
    spec.unit = unit;
    spec.type = type;
    spec.defaultValue = std::move(standard);
    spec.minimum = minimum;
    spec.maximum = maximum;
    spec.help = help;
    return spec;
}

}  // namespace

const ParameterTable& outlineParameters() {
    using enum ParameterType;
    static const ParameterTable table{
        choiceOf("side", "Take what lies", "inside", {"inside", "outside"},
                 "The points within the outline, or all others that are seen."),
        numberOf("depth_m", "Depth", "m", real, std::monostate{}, 0.001, 10000,
                 "Only what lies at most this far behind the nearest surface under the outline is taken; "
                 "none: however deep, and what is taken without being seen is counted."),
        choiceOf("scope", "Of the layers", "shown", {"shown", "selected"},
                 "All layers that are shown, or the selected one alone."),
    };
    return table;
}

const ParameterTable& outlierSearchParameters() {
    using enum ParameterType;
    static const ParameterTable table{
        choiceOf("method", "Judge a point by", "distance", {"distance", "number"},
                 "Its mean distance to its nearest neighbours, or the number of neighbours within a radius."),
        numberOf("neighbours", "Nearest neighbours", "", integer, std::int64_t{8}, 1, 1000,
                 "By distance: how many neighbours are asked."),
        numberOf(
            "sigmas", "Limit", "SD", real, 3.0, 0, 100,
            "By distance: an outlier lies above the mean of all mean distances by more than this many of "
            "their standard deviations."),
        numberOf("radius_m", "Radius", "m", real, std::monostate{}, 1e-6, 1000,
                 "By number: neighbours lie within this distance; automatic: 3 times the median spacing."),
        numberOf("fewest", "Fewest neighbours", "", integer, std::int64_t{2}, 1, 10000,
                 "By number: a point with fewer others within the radius is an outlier."),
    };
    return table;
}

const ParameterTable& groundSearchParameters() {
    using enum ParameterType;
    static const ParameterTable table{
        numberOf("cell_m", "Cell", "m", real, 0.5, 0.05, 20,
                 "Edge of the squares whose lowest points begin the search; several points should fall into "
                 "one."),
        numberOf("widest_m", "Widest thing", "m", real, 18.0, 0.5, 200,
                 "What stands on the ground and is narrower than this is no ground."),
        numberOf("slope", "Steepest ground", "m/m", real, 0.15, 0.01, 2,
                 "Rise over run that the ground may have from one bend to the next."),
        numberOf("tolerance_m", "Tolerance", "m", real, std::monostate{}, 0.001, 2,
                 "A point this near to the ground's surface is ground; automatic: 3 times the scatter of the "
                 "points round it, 0.02 m to 0.15 m."),
    };
    return table;
}

const ParameterTable& objectSearchParameters() {
    using enum ParameterType;
    static const ParameterTable table{
        numberOf("gap_m", "Gap", "m", real, 0.12, 0.01, 5,
                 "Cubes of this edge that touch and hold points belong to one object; three times the "
                 "spacing of the points or "
                 "more, and less than what stands apart."),
        numberOf("fewest", "Fewest points", "", integer, std::int64_t{40}, 3, 10000000,
                 "Anything of fewer points is passed over."),
        numberOf("smallest_m", "Smallest", "m", real, 0.1, 0.001, 100,
                 "Anything whose longest side is shorter is passed over."),
        numberOf("largest_m", "Largest", "m", real, 25.0, 0.01, 1000,
                 "Anything whose longest side is longer is passed over: buildings, rows of trees."),
        numberOf("highest_m", "Highest", "m", real, 6.0, 0.05, 200,
                 "Points higher above the ground are passed over: crowns of trees, wires."),
    };
    return table;
}

OutlierOptions outlierOptions(const ParameterSet& parameters, double metresPerUnit) {
    OutlierOptions options;
    options.method =
        parameters.text("method") == "distance" ? OutlierMethod::statistical : OutlierMethod::radius;
    options.neighbours = static_cast<int>(parameters.integer("neighbours"));
    options.sigmas = parameters.real("sigmas");
    options.radius = parameters.optionalReal("radius_m").value_or(0) / metresPerUnit;
    options.minimumNeighbours = static_cast<int>(parameters.integer("fewest"));
    return options;
}

GroundOptions groundOptions(const ParameterSet& parameters) {
    return {parameters.real("cell_m"), parameters.real("widest_m"), parameters.real("slope"),
            parameters.optionalReal("tolerance_m")};
}

ObjectOptions objectOptions(const ParameterSet& parameters) {
    return {parameters.real("gap_m"), static_cast<std::size_t>(parameters.integer("fewest")),
            parameters.real("smallest_m"), parameters.real("largest_m"), parameters.real("highest_m")};
}

std::string describe(const ParameterSet& parameters) {
    std::string text;
    for (const ParameterSpec& spec : parameters.table())
        text += (text.empty() ? "" : "; ") + spec.label + ": " + parameters.display(spec.key);
    return text;
}

}  // namespace vestige
