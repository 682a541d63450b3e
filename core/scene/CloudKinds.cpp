#include "core/scene/CloudKinds.h"

#include <utility>

#include "core/base/CancelScope.h"
#include "core/scene/KindOutcomes.h"

namespace vestige {
namespace {

thread_local CloudKindsLater* innermost = nullptr;

}  // namespace

CloudKindsLater::CloudKindsLater(bool givenUp) : givenUp_(givenUp), outer_(innermost) {
    innermost = this;
}

CloudKindsLater::~CloudKindsLater() {
    innermost = outer_;
}

CloudKindsLater* CloudKindsLater::current() {
    return innermost;
}

KindOutcome CloudKindsLater::leave(KindRepeats repeats) {
    missing_.push_back(std::move(repeats));
    return {{},
            {},
            {givenUp_ ? "not computed; the next change of the case takes it up"
                      : "being computed from the cloud"}};
}

Status computeCloudKinds(const SceneState& scene, const std::vector<KindRepeats>& missing,
                         const JobControl& control) {
    const auto done = guarded("measuring in the clouds", [&]() -> Result<bool> {
        const CancelScope scope(control);
        for (std::size_t i = 0; i < missing.size(); ++i) {
            throwIfCancelled();
            control.progress(static_cast<double>(i) / static_cast<double>(missing.size()),
                             kindSpec(missing[i].measurement.kind).label);
            outcomeOf(scene, missing[i]);
        }
        return true;
    });
    if (!done) return fail(done.error());
    return {};
}

}  // namespace vestige
