#include "core/filters/Preprocess.h"

namespace vestige {
namespace {

ParameterSpec choiceOf(const char* key, const char* label, const char* standard,
                       std::vector<std::string> choices, const char* help) {
    ParameterSpec spec;
    spec.key = spec.flag = key;
    spec.label = label;
    spec.type = ParameterType::choice;
    spec.defaultValue = std::string(standard);
    spec.choices = std::move(choices);
    spec.help = help;
    return spec;
}

ParameterSpec number(const char* key, const char* flag, const char* label, const char* unit,
                     ParameterType type, ParameterValue standard, double minimum, double maximum,
                     const char* help) {
    ParameterSpec spec;
    spec.key = key;
    spec.flag = flag;
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

const ParameterTable& preprocessParameters() {
    using enum ParameterType;
    static const ParameterTable table{
        choiceOf("filter", "Filter", "gaussian", {"none", "mean", "median", "gaussian"},
                 "Statistic of its neighbours that replaces each point's position."),
        number("radius_m", "radius", "Radius of the neighbourhood", "m", real, std::monostate{}, 1e-6, 1000,
               "Neighbours of the filter and of radius outliers lie within this distance; automatic: 3 times "
               "the median spacing of the points."),
        number("voxel_m", "voxel", "Voxel size", "m", real, std::monostate{}, 1e-6, 1e4,
               "Edge of the voxels that are thinned to one point each; automatic: no thinning."),
        choiceOf("representative", "Point of a voxel", "centroid", {"centroid", "nearest"},
                 "What stands for a voxel: the centroid of its points, attributes averaged, or the measured "
                 "point nearest to it."),
        choiceOf("outliers", "Outliers", "none", {"none", "sor", "ror"},
                 "How outliers are found before filtering: by the mean distance to the nearest neighbours "
                 "(sor), by the number of neighbours within the radius (ror)."),
        number("sor_neighbours", "sor-neighbours", "Neighbours (sor)", "", integer, std::int64_t{8}, 1, 1000,
               "Nearest neighbours whose mean distance judges a point."),
        number("sor_sigmas", "sor-sigmas", "Limit (sor)", "", real, 3.0, 0, 100,
               "A point is an outlier above the mean of these distances plus this many of their standard "
               "deviations."),
        number("ror_neighbours", "ror-neighbours", "Fewest neighbours (ror)", "", integer, std::int64_t{2}, 1,
               10000, "A point with fewer others within the radius is an outlier."),
    };
    return table;
}

}  // namespace vestige
