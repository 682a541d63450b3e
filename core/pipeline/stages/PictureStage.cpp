#include "core/pipeline/PicturePlan.h"
#include "core/pipeline/ReconstructRun.h"

namespace vestige {

Status pictureStage(ReconstructRun& run, const JobControl& control) {
    const auto planned = planPictures(run.scene, run.measured);
    for (std::size_t i = 0; i < planned.size(); ++i) {
        const PlannedPicture& picture = planned[i];
        if (!run.renderer) {
            run.notMade.push_back(picture.file);
            continue;
        }
        if (control.cancelled()) return fail(cancelledError());
        const auto count = static_cast<double>(planned.size());
        const auto png = run.output.path(picture.file);
        const JobControl sub =
            control.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        sub.progress(0, "picture " + picture.file);
        if (const Status drawn = run.renderer->renderPng(picture.view, png, sub); !drawn) return drawn;
        run.pictures.push_back({picture.kind, picture.subject, png, picture.caption, picture.toScale});
    }
    return {};
}

}  // namespace vestige
