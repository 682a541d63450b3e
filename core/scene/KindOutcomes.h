#pragma once

#include "core/scene/KindRepeats.h"

namespace vestige {

/// kindStatistics of the repeats, with the cloud round the picks where the kind looks at it. Of such kinds
/// the last outcomes are remembered: an edit elsewhere in the case does not ask the clouds again. The same
/// for the same arguments; any thread may call it.
KindOutcome outcomeOf(const SceneState& scene, KindRepeats repeats);

}  // namespace vestige
