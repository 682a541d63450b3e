#include "core/registration/RegistrationResult.h"

namespace vestige {

std::string_view describe(StopReason reason) {
    switch (reason) {
        case StopReason::gradient:
            return "the score's slope vanished";
        case StopReason::step:
            return "the step became negligible";
        case StopReason::predictedDecrease:
            return "no further decrease was predicted";
        case StopReason::iterationLimit:
            return "the limit of iterations was reached, not converged";
        case StopReason::noOverlap:
            return "no source point lies in a cell of the target";
    }
    return "";
}

std::string_view describe(Verdict verdict) {
    switch (verdict) {
        case Verdict::accepted:
            return "accepted";
        case Verdict::doubtful:
            return "doubtful";
        case Verdict::failed:
            return "failed";
        case Verdict::ambiguous:
            return "ambiguous";
    }
    return "";
}

}  // namespace vestige
