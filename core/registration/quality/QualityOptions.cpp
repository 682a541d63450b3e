#include "core/registration/quality/QualityOptions.h"

namespace vestige {

QualityOptions qualityOptions(const ParameterSet& parameters) {
    QualityOptions options;
    options.restarts = static_cast<int>(parameters.integer("restarts"));
    options.leastOverlap = parameters.real("least_overlap");
    options.failedSupport = parameters.real("failed_support");
    options.doubtfulSupport = parameters.real("doubtful_support");
    options.freeSigma_m = parameters.real("free_sigma_m");
    options.doubtfulSeenThrough = parameters.real("doubtful_seen_through");
    options.failedSeenThrough = parameters.real("failed_seen_through");
    options.doubtfulTurn_deg = parameters.real("doubtful_turn_deg");
    options.doubtfulUncertainty_m = parameters.real("doubtful_uncertainty_m");
    return options;
}

}  // namespace vestige
