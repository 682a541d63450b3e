#include "core/filters/Preprocess.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/filters/Neighbourhood.h"
#include "core/filters/Outliers.h"
#include "core/filters/Spacing.h"
#include "core/filters/VoxelDownsample.h"

namespace vestige {
namespace {

OutlierOptions outlierOptions(const ParameterSet& parameters, double unitsPerMetre) {
    OutlierOptions options;
    const std::string& method = parameters.text("outliers");
    if (method == "sor") options.method = OutlierMethod::statistical;
    if (method == "ror") options.method = OutlierMethod::radius;
    options.neighbours = static_cast<int>(parameters.integer("sor_neighbours"));
    options.sigmas = parameters.real("sor_sigmas");
    options.minimumNeighbours = static_cast<int>(parameters.integer("ror_neighbours"));
    options.radius = parameters.optionalReal("radius_m").value_or(0) * unitsPerMetre;
    return options;
}

NeighbourhoodOptions filterOptions(const ParameterSet& parameters, double unitsPerMetre) {
    NeighbourhoodOptions options;
    const std::string& filter = parameters.text("filter");
    options.filter = filter == "mean"       ? NeighbourhoodFilter::mean
                     : filter == "median"   ? NeighbourhoodFilter::median
                     : filter == "gaussian" ? NeighbourhoodFilter::gaussian
                                            : NeighbourhoodFilter::none;
    options.radius = parameters.optionalReal("radius_m").value_or(0) * unitsPerMetre;
    return options;
}

}  // namespace

ParameterSet withChosenRadius(const PointCloud& cloud, const ParameterSet& parameters, double metresPerUnit,
                              const JobControl& control) {
    ParameterSet chosen = parameters;
    const bool searches = parameters.text("filter") != "none" || parameters.text("outliers") == "ror";
    if (!searches || parameters.optionalReal("radius_m")) return chosen;
    const ParameterSpec& spec = *parameters.find("radius_m");
    const double automatic = automaticRadius(cloud) * metresPerUnit;
    // No two points apart: whatever the radius, the cloud stays.
    if (!(automatic > 0)) return chosen;
    const double radius = std::clamp(automatic, *spec.minimum, *spec.maximum);
    // Within the parameter's own range, so it is always accepted.
    (void)chosen.set("radius_m", radius);
    control.message("neighbourhood radius: " + fixedText(radius, 4) +
                    " m, 3 times the median spacing of the points");
    return chosen;
}

Result<PointCloud> preprocess(const PointCloud& cloud, const ParameterSet& parameters, double metresPerUnit,
                              const JobControl& control) {
    if (!(metresPerUnit > 0)) return fail(ErrorCode::usage, "a unit of no length", "preprocess");
    const double unitsPerMetre = 1 / metresPerUnit;
    const ParameterSet chosen = withChosenRadius(cloud, parameters, metresPerUnit, control);
    auto kept = removeOutliers(cloud, outlierOptions(chosen, unitsPerMetre), control.sub(0, 0.35));
    if (!kept) return kept;
    if (control.cancelled()) return fail(cancelledError());
    auto filtered = filterNeighbourhood(*kept, filterOptions(chosen, unitsPerMetre), control.sub(0.35, 0.8));
    if (!filtered) return filtered;
    if (control.cancelled()) return fail(cancelledError());
    const auto voxel = chosen.optionalReal("voxel_m");
    if (!voxel) return filtered;
    const auto representative = chosen.text("representative") == "nearest" ? VoxelRepresentative::nearest
                                                                           : VoxelRepresentative::centroid;
    return downsample(*filtered, *voxel * unitsPerMetre, representative, control.sub(0.8, 1));
}

}  // namespace vestige
