#include "core/evaluation/EvaluationPlan.h"

#include <algorithm>
#include <cstdint>

#include "core/registration/Register.h"

namespace vestige {
ParameterSet comparedRegistration() {
    ParameterSet parameters(registrationParameters());
    // Within the parameter's own range, so it is always accepted.
    (void)parameters.set("restarts", std::int64_t{0});
    return parameters;
}

EvaluationChoice publishedChoice(int table) {
    if (table == 2) return {{"ndt", "improved-ndt"}, {"1.0", "0.8", "0.6", "0.4", "0.2", "0.1"}, {"none"}};
    if (table == 3) return {{"improved-ndt"}, {"0.1", "0.2", "0.3"}, {"gaussian", "mean", "median"}};
    return {};
}

Result<std::vector<EvaluationRun>> evaluationRuns(const std::vector<EvaluationChoice>& choices,
                                                  const ParameterSet& preprocessing,
                                                  const ParameterSet& registration) {
    std::vector<EvaluationRun> runs;
    for (const EvaluationChoice& choice : choices)
        for (const std::string& filter : choice.filters)
            for (const std::string& method : choice.methods)
                for (const std::string& voxel : choice.voxels) {
                    EvaluationRun run{preprocessing, registration};
                    for (const Status& set : {run.preprocessing.setFromText("filter", filter),
                                              run.registration.setFromText("method", method),
                                              run.registration.setFromText("voxel_m", voxel)})
                        if (!set) return fail(set.error());
                    const bool known = std::any_of(runs.begin(), runs.end(), [&](const EvaluationRun& one) {
                        return one.preprocessing == run.preprocessing && one.registration == run.registration;
                    });
                    if (!known) runs.push_back(std::move(run));
                }
    return runs;
}

}  // namespace vestige
