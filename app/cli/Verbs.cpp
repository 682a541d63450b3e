#include "app/cli/Session.h"

namespace vestige::cli {

const std::vector<Verb>& verbs() {
    static const std::vector<Verb> all{
        {"info", "What clouds and meshes are and hold, with their SHA-256.", declareInfo},
        {"convert", "From any readable to any writable format, by extension.", declareConvert},
        {"simulate", "Clouds, cases and truth of a synthetic accident scene.", declareSimulate},
        {"preprocess", "A cloud without its outliers, smoothed and thinned.", declarePreprocess},
        {"register", "The pose that lays one cloud or mesh on another.", declareRegister},
        {"evaluate", "Registration of a sequence against its known poses, by method, voxel and filter.",
         declareEvaluate},
        {"accuracy", "Measured lengths against the tape: RE, RMSE, exclusion.", declareAccuracy},
        {"reconstruct", "The main job: registers, measures and reports a case.", declareReconstruct},
        {"screenshot", "A picture of a case, or of any clouds and meshes, without a display.",
         declareScreenshot},
    };
    return all;
}

}  // namespace vestige::cli
