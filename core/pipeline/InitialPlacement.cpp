#include "core/pipeline/InitialPlacement.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/base/UnitWords.h"
#include "core/registration/InitialPose.h"
#include "core/scene/LayerUnit.h"

namespace vestige {
namespace {

/// Beyond the picks' own residuals: a picked pair is good to some decimetres at worst.
constexpr double kPickReach_m = 2;

std::string describePairs(const PairAlignment& alignment) {
    std::string residuals;
    for (const double residual : alignment.residuals_m)
        residuals += (residuals.empty() ? "" : ", ") + fixedText(1000 * residual, 1);
    return "first pose from " + std::to_string(alignment.residuals_m.size()) +
           " picked pairs, each good to " + fixedText(1000 * alignment.error_m, 1) + " mm (residuals " +
           residuals + ")";
}

struct UnitChoice {
    double metresPerUnit;
    std::vector<std::string> notes;
};

std::string shortWord(double metresPerUnit) {
    const auto unit = lengthUnitOf(metresPerUnit);
    return unit ? std::string(symbol(*unit)) : unitWords(metresPerUnit);
}

/// The unit the case gives, else the recognised one; a recognised unit that disagrees is told. Of the pairs
/// the target's points are in metres.
UnitChoice chooseUnit(const Layer& layer, const Layer& target, std::span<const PointPair> pairs) {
    const UnitGuess guess = guessUnit(*target.data->geometry, target.metresPerUnit(), *layer.data->geometry,
                                      pairs, fileMetresPerUnit(layer));
    if (!layer.unit)
        return {guess.metresPerUnit,
                {"unit recognised as " + shortWord(guess.metresPerUnit) + ": " + guess.reason}};
    const double given = metresPer(*layer.unit);
    if (guess.certain && guess.metresPerUnit != given)
        return {given,
                {"the case gives the unit " + shortWord(given) + ", but it looks like " +
                 shortWord(guess.metresPerUnit) + ": " + guess.reason}};
    return {given, {}};
}

Result<InitialPlacement> fromPicks(const SceneState& scene, const Layer& layer, const Layer& target,
                                   const InitPicks& init) {
    const auto pairs = readPointPairs(scene.resolve(init.picks));
    if (!pairs) return fail(pairs.error());
    std::vector<PointPair> metric = *pairs;
    for (PointPair& pair : metric) pair.target *= target.metresPerUnit();
    UnitChoice choice = chooseUnit(layer, target, metric);
    const auto alignment = alignPairs(metric, choice.metresPerUnit);
    if (!alignment) {
        Error error = alignment.error();
        error.place = scene.resolve(init.picks).string();
        return fail(std::move(error));
    }
    InitialPlacement placement{
        alignment->targetFromSource, std::nullopt, alignment->error_m, std::move(choice.notes), {}};
    const double worst = *std::max_element(alignment->residuals_m.begin(), alignment->residuals_m.end());
    placement.reach_m = kPickReach_m + 3 * worst;
    placement.notes.push_back(describePairs(*alignment));
    return placement;
}

Result<InitialPlacement> fromSearch(const SceneState& scene, const Layer& layer, const Layer& target,
                                    const JobControl& control) {
    const Similarity metresFromTarget{Pose::Identity(), target.metresPerUnit()};
    const std::optional<double> unit = layer.unit ? metresPer(*layer.unit) : fileMetresPerUnit(layer);
    const auto searchIn = [&](const TriangleMesh& inMetres) {
        return findFirstPose(inMetres, *layer.data->geometry, unit, scene.registration, control);
    };
    const TriangleMesh& geometry = *target.data->geometry;
    // A search asks for no attributes, so that none are copied.
    auto found = metresFromTarget.isIdentity()
                     ? searchIn(geometry)
                     : searchIn({geometry.vertices.withAttributes({}).transformed(metresFromTarget),
                                 geometry.triangles});
    if (!found) return fail(found.error());
    InitialPlacement placement{found->targetFromSource, kPickReach_m, found->error_m, {}, {}};
    placement.found = std::move(*found);
    return placement;
}

}  // namespace

Result<InitialPlacement> initialPlacement(const SceneState& scene, const Layer& layer, const Layer& target,
                                          const JobControl& control) {
    if (const auto* picks = std::get_if<InitPicks>(&layer.init))
        return fromPicks(scene, layer, target, *picks);
    if (std::holds_alternative<InitAuto>(layer.init)) return fromSearch(scene, layer, target, control);
    if (const auto* pose = std::get_if<InitPose>(&layer.init))
        return InitialPlacement{pose->targetFromSource, kPickReach_m, std::nullopt, {}, {}};
    UnitChoice choice = chooseUnit(layer, target, {});
    return InitialPlacement{
        {Pose::Identity(), choice.metresPerUnit}, std::nullopt, std::nullopt, std::move(choice.notes), {}};
}

}  // namespace vestige
