#include "core/pipeline/joint/AdjustLayers.h"

#include <algorithm>

#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/pipeline/joint/PairUncertainty.h"

namespace vestige {
namespace {

/// A loop that fails to close by more than its pairs allow makes its layers doubtful from here on: less is no
/// more than the unevenness of the clouds.
constexpr double kDoubtfulClosure_m = 0.02;
constexpr double kDoubtfulTurn_rad = radians(0.5);
/// A right registration is within this of the truth, so a loop of right ones closes within it.
constexpr double kWrongClosure_m = 0.1;
constexpr double kWrongTurn_rad = radians(1.0);
constexpr double kFalseAlarm = 0.001;

std::string closureText(double metres, double radians_) {
    return fixedText(1000 * metres, 1) + " mm and " + fixedText(degrees(radians_), 3) + "\u00b0";
}

class Adjusting {
  public:
    Adjusting(const SceneState& scene, const PairedLayers& paired, const JobControl& control)
        : scene_(scene), paired_(paired), control_(control), layers_(layerGraph(paired)) {}

    AttemptedLayers run();

  private:
    const std::string& id(std::size_t member) const { return paired_.members[member].layer.id; }
    const std::string& layerName(std::size_t member) const { return paired_.members[member].layer.name; }
    bool isTarget(std::size_t member) const { return id(member) == scene_.target; }
    bool standAlone() const;
    void adjust();
    Error unreached(std::size_t member) const;
    RegistrationResult resultOf(const TreeStep& step) const;
    void judge(std::size_t member, RegistrationResult& result) const;
    JointAdjustment told() const;
    std::string loopText(const LoopError& loop) const;

    const SceneState& scene_;
    const PairedLayers& paired_;
    const JobControl& control_;
    LayerGraph layers_;
    AdjustedGraph adjusted_;
};

/// Whether no layer has another pair than its own with the target.
bool Adjusting::standAlone() const {
    return std::all_of(layers_.graph.edges.begin(), layers_.graph.edges.end(),
                       [&](const PoseEdge& edge) { return isTarget(edge.to); });
}

/// Pairs that contradict each other so that nothing tells which is wrong: where they do so by more than a
/// right registration may, the one between two scans that has the least overlap gives way to those with the
/// target, which stand by themselves.
void Adjusting::adjust() {
    const PoseGraph& graph = layers_.graph;
    std::vector<bool> allowed(graph.edges.size(), true);
    std::vector<std::string> whyNot(graph.edges.size());
    for (;;) {
        adjusted_ =
            adjustGraph(graph, {kFalseAlarm, kDoubtfulClosure_m, kDoubtfulTurn_rad}, allowed, control_);
        std::size_t weakest = graph.edges.size();
        for (const LoopError& loop : adjusted_.loops) {
            const bool wrong = loop.translation_m > kWrongClosure_m || loop.rotation_rad > kWrongTurn_rad;
            if (!wrong || loop.probability > kFalseAlarm) continue;
            for (const std::size_t e : loop.edges) {
                const bool suspect = std::find(adjusted_.suspects.begin(), adjusted_.suspects.end(), e) !=
                                     adjusted_.suspects.end();
                if (!suspect || isTarget(graph.edges[e].to)) continue;
                const auto overlap = [&](std::size_t edge) {
                    return paired_.pairs[layers_.edgePairs[edge]].result->overlap;
                };
                if (weakest == graph.edges.size() || overlap(e) < overlap(weakest)) weakest = e;
            }
        }
        if (weakest == graph.edges.size()) break;
        allowed[weakest] = false;
        whyNot[weakest] =
            "it contradicts the layers' own registrations to the target; which is right cannot be told";
    }
    for (std::size_t e = 0; e < whyNot.size(); ++e)
        if (!whyNot[e].empty()) adjusted_.edges[e].whyNot = whyNot[e];
}

Error Adjusting::unreached(std::size_t member) const {
    const Member& lost = paired_.members[member];
    Error error = lost.failure.value_or(
        Error{ErrorCode::untrustworthy, "no layer that has its place overlaps it", "layer " + lost.layer.id,
              "give a nearer first pose, or a scan between them"});
    std::string others;
    for (const MemberPair& pair : paired_.pairs) {
        if (pair.result || (pair.to != member && pair.from != member)) continue;
        const std::size_t other = pair.to == member ? pair.from : pair.to;
        if (!isTarget(other)) others += (others.empty() ? "" : ", ") + id(other);
    }
    if (!others.empty()) error.message += "; nor can it be registered to " + others;
    return error;
}

std::string Adjusting::loopText(const LoopError& loop) const {
    std::string text;
    for (const std::size_t node : loop.nodes) text += layerName(node) + " - ";
    return text + layerName(loop.nodes.front());
}

/// What a layer's pair in the surest tree says, with the adjusted pose.
RegistrationResult Adjusting::resultOf(const TreeStep& step) const {
    const MemberPair& pair = paired_.pairs[layers_.edgePairs[step.edge]];
    const bool isSource = pair.from == step.node;
    RegistrationResult result = *pair.result;
    const Pose sceneFromOther = *adjusted_.fit.poses[step.before];
    const double scale = paired_.members[step.node].place->scale;
    const auto inScene = [&](const Pose& toFromFrom) {
        const Pose relative = isSource ? toFromFrom : toFromFrom.inverse();
        return isTarget(step.before) ? relative : sceneFromOther * relative;
    };
    result.targetFromSource = {*adjusted_.fit.poses[step.node], scale};
    result.initial = {inScene(result.initial.pose), scale};
    for (RegistrationLevel& level : result.levels) level.targetFromSource = inScene(level.targetFromSource);
    if (!isSource) std::swap(result.overlap, result.targetOverlap);
    for (std::size_t e = 0; e < adjusted_.edges.size(); ++e) {
        const PoseEdge& edge = layers_.graph.edges[e];
        if (!adjusted_.edges[e].used || (edge.to != step.node && edge.from != step.node)) continue;
        result.via.push_back(id(edge.to == step.node ? edge.from : edge.to));
    }
    const Pose& chained = adjusted_.unadjusted[step.node]->pose;
    if (result.quality) {
        const Eigen::Matrix3d turn =
            isTarget(step.before)
                ? Eigen::Matrix3d::Identity().eval()
                : (isSource ? sceneFromOther : result.targetFromSource.pose).linear().eval();
        for (ObservedDirection& one : result.quality->directions)
            one.direction << turn * one.direction.head<3>(), turn * one.direction.tail<3>();
        result.quality->uncertainty = *adjusted_.fit.uncertainty[step.node];
    }
    const Eigen::Vector3d centre = layers_.graph.nodes[step.node].centre_m;
    std::string neighbours;
    for (const std::string& other : result.via) neighbours += (neighbours.empty() ? "" : ", ") + other;
    result.notes.push_back(
        "adjusted together with its neighbours (" + neighbours + "), which moved it by " +
        closureText((result.targetFromSource.pose * centre - chained * centre).norm(),
                    rotationAngle(result.targetFromSource.pose.linear() * chained.linear().transpose())));
    return result;
}

/// Loops through the layer that do not close.
void Adjusting::judge(std::size_t member, RegistrationResult& result) const {
    for (const LoopError& loop : adjusted_.loops) {
        const bool through = std::find(loop.nodes.begin(), loop.nodes.end(), member) != loop.nodes.end();
        const bool open = loop.translation_m > kDoubtfulClosure_m || loop.rotation_rad > kDoubtfulTurn_rad;
        // A pair that the others prove wrong does them no harm.
        const bool proven = !adjusted_.edges[loop.closing].used && adjusted_.suspects.empty() &&
                            adjusted_.edges[loop.closing].controlled && adjusted_.consistent;
        if (!through || !open || proven || loop.probability > kFalseAlarm) continue;
        if (result.verdict == Verdict::accepted) result.verdict = Verdict::doubtful;
        result.reasons.insert(result.reasons.begin(), "the loop " + loopText(loop) + " fails to close by " +
                                                          closureText(loop.translation_m, loop.rotation_rad) +
                                                          ", more than its registrations allow");
    }
}

JointAdjustment Adjusting::told() const {
    JointAdjustment told;
    std::vector<std::size_t> edgeOf(paired_.pairs.size(), layers_.graph.edges.size());
    for (std::size_t e = 0; e < layers_.edgePairs.size(); ++e) edgeOf[layers_.edgePairs[e]] = e;
    for (std::size_t p = 0; p < paired_.pairs.size(); ++p) {
        const MemberPair& pair = paired_.pairs[p];
        AdjustedPair one;
        one.to = id(pair.to);
        one.from = id(pair.from);
        one.whyNot = pair.whyNot;
        if (pair.result) {
            const AdjustedEdge& edge = adjusted_.edges[edgeOf[p]];
            one.found = pair.result->targetFromSource;
            one.overlap = pair.result->overlap;
            one.rmse_m = pair.result->rmse_m;
            one.uncertainty = layers_.graph.edges[edgeOf[p]].uncertainty;
            one.used = edge.used;
            one.whyNot = edge.whyNot;
            one.correction_m = edge.residual.head<3>().norm();
            one.correction_rad = edge.residual.tail<3>().norm();
            one.controlled = edge.controlled;
            one.chiSquare = edge.chiSquare;
        }
        told.pairs.push_back(std::move(one));
    }
    for (const LoopError& loop : adjusted_.loops) {
        AdjustedLoop one{{}, loop.translation_m, loop.rotation_rad, loop.chiSquare, loop.probability};
        for (const std::size_t node : loop.nodes) one.layers.push_back(id(node));
        told.loops.push_back(std::move(one));
    }
    for (std::size_t i = 0; i < paired_.members.size(); ++i) {
        if (paired_.members[i].fixed || !adjusted_.fit.poses[i]) continue;
        const Pose& before = adjusted_.unadjusted[i]->pose;
        const Pose& after = *adjusted_.fit.poses[i];
        const Eigen::Vector3d& centre = layers_.graph.nodes[i].centre_m;
        told.layers.push_back({id(i), (after * centre - before * centre).norm(),
                               rotationAngle(after.linear() * before.linear().transpose()),
                               adjusted_.unadjusted[i]->uncertainty, *adjusted_.fit.uncertainty[i]});
    }
    told.chiSquare = adjusted_.fit.chiSquare;
    told.degreesOfFreedom = adjusted_.fit.degrees;
    told.varianceFactor = adjusted_.varianceFactor;
    told.consistent = adjusted_.consistent;
    return told;
}

AttemptedLayers Adjusting::run() {
    const bool alone = standAlone();
    adjust();
    std::vector<bool> used;
    for (const AdjustedEdge& edge : adjusted_.edges) used.push_back(edge.used);
    const auto tree = surestTree(layers_.graph, used);
    AttemptedLayers attempted;
    for (std::size_t i = 0; i < paired_.members.size(); ++i) {
        const Member& member = paired_.members[i];
        if (member.fixed) continue;
        // An input that is broken is told even where others reach the layer.
        if (member.failure && member.failure->code != ErrorCode::untrustworthy) {
            attempted.layers.push_back({id(i), fail(*member.failure), member.failure});
            continue;
        }
        const auto pairOf =
            std::find_if(paired_.pairs.begin(), paired_.pairs.end(),
                         [&](const MemberPair& pair) { return pair.result && pair.from == i; });
        const auto step =
            std::find_if(tree.begin(), tree.end(), [&](const TreeStep& one) { return one.node == i; });
        if (alone && pairOf != paired_.pairs.end()) {
            attempted.layers.push_back({id(i), *pairOf->result, {}});
        } else if (step != tree.end()) {
            RegistrationResult result = resultOf(*step);
            judge(i, result);
            attempted.layers.push_back({id(i), std::move(result), {}});
        } else {
            const Error error = unreached(i);
            attempted.layers.push_back(
                {id(i), member.attempt ? Result<RegistrationResult>(*member.attempt) : fail(error), error});
        }
    }
    if (!alone) attempted.adjustment = told();
    return attempted;
}

}  // namespace

LayerGraph layerGraph(const PairedLayers& paired) {
    LayerGraph layers;
    for (const Member& member : paired.members) {
        PoseNode node;
        node.fixed = member.fixed;
        const Eigen::Vector3d centre = member.layer.data->points->bounds().centre();
        node.centre_m = (member.place ? member.place->scale : member.layer.metresPerUnit()) * centre;
        if (member.fixed) node.pose = member.place->pose;
        layers.graph.nodes.push_back(node);
    }
    for (std::size_t p = 0; p < paired.pairs.size(); ++p) {
        const MemberPair& pair = paired.pairs[p];
        if (!pair.result) continue;
        layers.graph.edges.push_back({pair.to, pair.from, pair.result->targetFromSource.pose,
                                      pairUncertainty(*pair.result, paired.members[pair.from].layer)});
        layers.edgePairs.push_back(p);
    }
    return layers;
}

Result<AttemptedLayers> adjustLayers(const SceneState& scene, const PairedLayers& paired,
                                     const JobControl& control) {
    return guarded("registration",
                   [&]() -> Result<AttemptedLayers> { return Adjusting(scene, paired, control).run(); });
}

}  // namespace vestige
