#include "core/registration/FindPose.h"

#include <algorithm>

#include "core/registration/DenserSource.h"
#include "core/registration/icp/PointToPlaneIcp.h"
#include "core/registration/ndt/ClassicNdt.h"
#include "core/registration/ndt/ImprovedNdt.h"

namespace vestige {
namespace {

constexpr double kLargestStart_m = 4;
constexpr double kPaperStart_m = 1;  // the largest size of the publication's table 2
constexpr double kPaperTrustRadius_m = 0.1;
constexpr double kFloor_m = 0.1;
constexpr double kSmallRadius_m = 2;  // of a source that has few surfaces
constexpr double kSingleVoxel_m = 1;
/// A first pose that is known needs no cells that reach further than it may be off, 2 sigma to either side.
/// Smaller cells than this share of the source's radius hold too little of a surface (docs/decisions/0005).
constexpr double kStartErrorsPerCell = 4;
constexpr double kSmallestKnownStart = 1.0 / 4;

ImprovedNdtOptions ndtOptions(const ParameterSet& parameters, double sourceRadius_m) {
    const bool paper = parameters.text("preset") == "paper";
    ImprovedNdtOptions options;
    options.voxelStart_m = parameters.optionalReal("voxel_start_m")
                               .value_or(paper ? kPaperStart_m : std::min(kLargestStart_m, sourceRadius_m));
    const auto startError_m = parameters.optionalReal("start_error_m");
    if (startError_m && !paper && !parameters.optionalReal("voxel_start_m"))
        options.voxelStart_m = std::min(options.voxelStart_m, std::max(kStartErrorsPerCell * *startError_m,
                                                                       kSmallestKnownStart * sourceRadius_m));
    options.voxel_m = parameters.optionalReal("voxel_m");
    // A small thing needs smaller cells than a street.
    const bool small = sourceRadius_m < kSmallRadius_m;
    options.voxelFloor_m =
        paper ? std::min(kFloor_m, options.voxelStart_m / 20) : options.voxelStart_m / (small ? 16 : 32);
    options.leaf_m = parameters.optionalReal("leaf_m");
    options.published = paper;
    options.startFan = !paper && !startError_m && !parameters.optionalReal("voxel_start_m");
    // Where the cells are few, or larger than the data would have them, it matters where their faces lie.
    const bool given = options.voxel_m && !parameters.optionalReal("voxel_start_m") &&
                       2 * *options.voxel_m <= options.voxelStart_m;
    if (!paper && (startError_m || small || given)) options.shiftedGrids = 4;
    if (given && !options.leaf_m) options.leaf_m = *options.voxel_m / 2;
    if (!paper) options.voxelCeiling_m = std::max(options.voxelFloor_m, sourceRadius_m / 5);
    options.distributions.flatCellsInPlane = paper;
    options.distributions.outlierRatio = parameters.real("outlier_ratio");
    options.distributions.flatness = parameters.real("flatness");
    const auto noise_m = parameters.optionalReal("range_noise_m");
    options.distributions.rangeNoise_m = noise_m.value_or(0);
    options.estimateNoise = (startError_m || small) && !noise_m && !paper;
    options.trustRadius_m = parameters.optionalReal("trust_radius_m");
    if (paper && !options.trustRadius_m) options.trustRadius_m = kPaperTrustRadius_m;
    options.trustRegion.damping = parameters.real("damping");
    options.trustRegion.gradientLimit = parameters.real("gradient_limit");
    options.trustRegion.stepLimit_m = parameters.real("step_limit_m");
    options.trustRegion.iterationLimit = static_cast<int>(parameters.integer("max_iterations"));
    return options;
}

double singleVoxel(const ParameterSet& parameters, double sourceRadius_m) {
    return parameters.optionalReal("voxel_m").value_or(std::min(kSingleVoxel_m, sourceRadius_m / 4));
}

ClassicNdtOptions classicOptions(const ParameterSet& parameters, double sourceRadius_m) {
    const ImprovedNdtOptions ndt = ndtOptions(parameters, sourceRadius_m);
    return {singleVoxel(parameters, sourceRadius_m), ndt.leaf_m, ndt.distributions, ndt.trustRegion};
}

IcpOptions icpOptions(const ParameterSet& parameters, double sourceRadius_m) {
    return {singleVoxel(parameters, sourceRadius_m), parameters.optionalReal("leaf_m"),
            parameters.optionalReal("range_noise_m").value_or(0), parameters.real("step_limit_m"),
            static_cast<int>(parameters.integer("max_iterations"))};
}

/// A sentence for each parameter that the user set and that the method has no use for.
std::vector<std::string> withoutEffect(const ParameterSet& parameters) {
    const std::string& method = parameters.text("method");
    std::vector<const char*> unused;
    if (method == "ndt" || method == "icp") unused = {"voxel_start_m", "trust_radius_m"};
    if (method == "icp")
        for (const char* key : {"damping", "gradient_limit", "outlier_ratio", "flatness"})
            unused.push_back(key);
    std::vector<std::string> notes;
    for (const char* key : unused)
        if (!parameters.isDefault(key))
            notes.push_back("--" + parameters.find(key)->flag + " has no effect with the method " + method);
    return notes;
}

}  // namespace

Result<RegistrationResult> findPose(const PointCloud& target, const PointCloud& source,
                                    const Similarity& initial, const ParameterSet& parameters,
                                    const JobControl& control, const RegistrationWatch& watch) {
    if (target.empty() || source.empty())
        return fail(ErrorCode::untrustworthy, target.empty() ? "the target is empty" : "the source is empty");
    const double radius = initial.scale * surfaceRadius(source);
    if (!(radius > 0))
        return fail(ErrorCode::untrustworthy, "the source has no extent, it cannot be registered");
    if (auto found = findPoseOnDenserSource(target, source, initial, parameters, control, watch))
        return *std::move(found);
    const ImprovedNdtOptions ndt = ndtOptions(parameters, radius);
    const double margin = 2 * std::max(ndt.voxelStart_m, ndt.voxel_m.value_or(0)) + 0.5 * radius;
    const RegistrationFrame frame(target, source, initial, margin);
    const std::string method = parameters.text("method");
    Result<RegistrationResult> result =
        method == "ndt"   ? classicNdt(frame, initial, classicOptions(parameters, radius), control, watch)
        : method == "icp" ? pointToPlaneIcp(frame, initial, icpOptions(parameters, radius), control, watch)
                          : improvedNdt(frame, initial, ndt, control, watch);
    if (!result) return result;
    result->method = method;
    for (std::string& note : withoutEffect(parameters)) result->notes.push_back(std::move(note));
    result->initial = initial;
    result->radius_m = radius;
    return result;
}

}  // namespace vestige
