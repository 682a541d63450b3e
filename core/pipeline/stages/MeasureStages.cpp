#include "core/pipeline/ReconstructRun.h"
#include "core/pipeline/ResolveAims.h"
#include "core/report/CheckBlocks.h"

namespace vestige {

Status aimStage(ReconstructRun& run, const JobControl& control) {
    run.scene.measurements = resolveAims(run.scene, control);
    if (control.cancelled()) return fail(cancelledError());
    return {};
}

Status measureStage(ReconstructRun& run, const JobControl&) {
    run.measured = measureScene(run.scene);
    for (const std::string& failed : failedChecks(run.measured)) run.warnings.push_back(failed);
    return {};
}

}  // namespace vestige
