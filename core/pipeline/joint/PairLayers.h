#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/RegisterTogether.h"

namespace vestige {

/// A layer that takes part in a joint registration.
struct Member {
    Layer layer;                      ///< its unit known as soon as it has a place
    bool fixed = false;               ///< the target, or registered already and not to be registered anew
    std::optional<Similarity> place;  ///< scene from its file unit, as far as it is known
    bool settled = false;             ///< the place is given, or found by a registration: not a first pose
    std::optional<double> error_m;    ///< of the place, about
    std::optional<Error> failure;     ///< of the registration from its first pose
    std::optional<RegistrationResult> attempt;  ///< what that found, scene's frame, not to be relied on
};

/// Two members and what the registration of `from` to `to` gave.
struct MemberPair {
    std::size_t to = 0;
    std::size_t from = 0;
    std::optional<RegistrationResult> result;
    std::string whyNot;  ///< in plain words where there is no result to rely on
};

struct PairedLayers {
    std::vector<Member> members;  ///< in the order of the case
    std::vector<MemberPair> pairs;
};

/// Finds the place of every layer of `ids`, each from its first pose or through another layer, and registers
/// all pairs that are expected to overlap. Members that nothing places keep no place but a failure; a pair
/// that cannot be relied on has no result. See registerLayers().
Result<PairedLayers> pairLayers(const SceneState& scene, const std::vector<std::string>& ids,
                                PreparedLayers prepared, const JobControl& control,
                                const LayerWatches& watches);

}  // namespace vestige
