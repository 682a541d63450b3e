#pragma once

namespace vestige {

class PickChoices;
class PickFeedback;
class PickMover;
class PickProbe;

/// What every tool that picks works with.
struct PickAids {
    const PickChoices& choices;
    PickProbe& probe;
    PickFeedback& feedback;
    PickMover& mover;
};

}  // namespace vestige
