#include "core/registration/adjustment/AdjustGraph.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

#include "core/base/Numbers.h"
#include "core/registration/adjustment/LoopErrors.h"
#include "core/registration/adjustment/SignificanceTests.h"

namespace vestige {
namespace {

/// Covariances are taken to be too small, and made larger, only on this much evidence.
constexpr double kDisagreement = 0.05;

std::size_t nodesInReach(const FittedPoses& fit) {
    return static_cast<std::size_t>(
        std::count_if(fit.poses.begin(), fit.poses.end(), [](const auto& pose) { return pose.has_value(); }));
}

/// A fit without some edges, which reaches what the whole reaches.
struct Trial {
    std::vector<std::size_t> without;
    double chiSquare = 0;
};

void sortByFit(std::vector<Trial>& trials) {
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& a, const Trial& b) { return a.chiSquare < b.chiSquare; });
}

/// A graph that is being tried with some of its edges.
struct Trying {
    const PoseGraph& graph;
    const std::vector<bool>& used;
    const FittedPoses& fit;  ///< with all that are used
    const JobControl& control;

    void attempt(std::vector<std::size_t> without, std::vector<Trial>& trials) const {
        if (control.cancelled()) throw ErrorException{cancelledError()};
        std::vector<bool> others = used;
        for (const std::size_t e : without) others[e] = false;
        const FittedPoses rest = fitPoses(graph, others);
        if (nodesInReach(rest) == nodesInReach(fit)) trials.push_back({std::move(without), rest.chiSquare});
    }

    /// All fits without one of the edges used, the best first.
    std::vector<Trial> withoutOne() const {
        std::vector<Trial> trials;
        for (std::size_t e = 0; e < used.size(); ++e)
            if (used[e]) attempt({e}, trials);
        sortByFit(trials);
        return trials;
    }

    /// Fits without two edges, the best first: of the edges whose own absence helps most, since the number of
    /// pairs of all edges grows with the fourth power of that of the scans.
    std::vector<Trial> withoutTwo(const std::vector<Trial>& withoutOne) const {
        constexpr std::size_t kCandidates = 24;
        std::vector<std::size_t> candidates;
        for (const Trial& trial : withoutOne)
            if (candidates.size() < kCandidates) candidates.push_back(trial.without.front());
        std::sort(candidates.begin(), candidates.end());
        std::vector<Trial> trials;
        for (std::size_t a = 0; a < candidates.size(); ++a)
            for (std::size_t b = a + 1; b < candidates.size(); ++b)
                attempt({candidates[a], candidates[b]}, trials);
        sortByFit(trials);
        return trials;
    }
};

/// How probable it is that the sum of squares falls by `drop` where nothing is wrong, given what remains.
double probabilityOf(double drop, int dropDegrees, double remaining, int degrees) {
    if (degrees == 0 || remaining <= degrees) return chiSquareTail(drop, dropDegrees);
    return fisherTail(drop / dropDegrees / (remaining / degrees), dropDegrees, degrees);
}

std::string whyRejected(double probability) {
    return "the other pairs contradict it (probability " +
           (probability < 1e-6 ? "below 0.000001" : fixedText(probability, 6)) + ")";
}

/// Which edges the fit is significantly better without.
struct Outliers {
    std::vector<std::size_t> edges;
    double probability = 1;  ///< of so large an improvement where nothing is wrong
    bool certain = true;     ///< leaving out no other edges does nearly as well
};

/// Whether every one of the edges is off by enough where the others alone place its nodes.
bool farOff(const PoseGraph& graph, const std::vector<bool>& used, const std::vector<std::size_t>& edges,
            const AdjustmentOptions& options) {
    std::vector<bool> others = used;
    for (const std::size_t e : edges) others[e] = false;
    const FittedPoses rest = fitPoses(graph, others);
    return std::all_of(edges.begin(), edges.end(), [&](std::size_t e) {
        const PoseEdge& edge = graph.edges[e];
        const Vector6d off = edgeResidual(edge, *rest.poses[edge.to], *rest.poses[edge.from],
                                          Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero())
                                 .value;
        return off.head<3>().norm() >= options.leastWrong_m || off.tail<3>().norm() >= options.leastWrong_rad;
    });
}

Outliers outliers(const Trying& trying, const AdjustmentOptions& options) {
    const FittedPoses& fit = trying.fit;
    const double falseAlarm = options.falseAlarm;
    if (fit.degrees == 0 || chiSquareTail(fit.chiSquare, fit.degrees) > falseAlarm) return {};
    const auto withoutOne = trying.withoutOne();
    // Two wrong edges hide each other from a search for one.
    for (const int count : {1, 2}) {
        const int degrees = fit.degrees - 6 * count;
        if (degrees < 0 || (count == 2 && degrees == 0)) break;
        const auto trials = count == 1 ? withoutOne : trying.withoutTwo(withoutOne);
        if (trials.empty()) break;
        const Trial& best = trials.front();
        Outliers found{best.without,
                       probabilityOf(fit.chiSquare - best.chiSquare, 6 * count, best.chiSquare, degrees),
                       true};
        if (found.probability > falseAlarm || !farOff(trying.graph, trying.used, best.without, options))
            continue;
        for (std::size_t i = 1; i < trials.size(); ++i) {
            const double worse = trials[i].chiSquare - best.chiSquare;
            if (degrees > 0 && probabilityOf(worse, 6, best.chiSquare, degrees) <= falseAlarm) break;
            found.certain = false;
            found.edges.insert(found.edges.end(), trials[i].without.begin(), trials[i].without.end());
        }
        std::sort(found.edges.begin(), found.edges.end());
        found.edges.erase(std::unique(found.edges.begin(), found.edges.end()), found.edges.end());
        return found;
    }
    return {};
}

}  // namespace

AdjustedGraph adjustGraph(const PoseGraph& graph, const AdjustmentOptions& options,
                          const std::vector<bool>& allowed, const JobControl& control) {
    AdjustedGraph adjusted;
    adjusted.edges.resize(graph.edges.size());
    std::vector<bool> used(graph.edges.size());
    std::vector<bool> measured(graph.edges.size());
    for (std::size_t e = 0; e < used.size(); ++e) {
        const bool wanted = allowed.empty() || allowed[e];
        used[e] = measured[e] = wanted && isUsable(graph.edges[e].uncertainty);
        if (wanted && !used[e]) adjusted.edges[e].whyNot = "its covariance is not positive definite";
    }
    adjusted.fit = fitPoses(graph, used);
    for (;;) {
        Outliers found = outliers({graph, used, adjusted.fit, control}, options);
        if (!found.certain) adjusted.suspects = std::move(found.edges);
        if (!found.certain || found.edges.empty()) break;
        for (const std::size_t e : found.edges) {
            used[e] = false;
            adjusted.edges[e].whyNot = whyRejected(found.probability);
        }
        adjusted.fit = fitPoses(graph, used);
    }

    FittedPoses& fit = adjusted.fit;
    const auto tree = surestTree(graph, used);
    adjusted.unadjusted = posesAlong(graph, tree);
    adjusted.loops = loopErrors(graph, tree, measured);
    for (const Trial& trial : Trying{graph, used, fit, control}.withoutOne()) {
        AdjustedEdge& edge = adjusted.edges[trial.without.front()];
        edge.controlled = true;
        edge.chiSquare = fit.chiSquare - trial.chiSquare;
    }
    for (std::size_t e = 0; e < used.size(); ++e) {
        const PoseEdge& edge = graph.edges[e];
        if (!fit.poses[edge.to] || !fit.poses[edge.from]) continue;
        adjusted.edges[e].used = used[e];
        if (measured[e] && !used[e]) {
            std::vector<bool> with = used;
            with[e] = true;
            adjusted.edges[e].controlled = true;
            adjusted.edges[e].chiSquare = fitPoses(graph, with).chiSquare - fit.chiSquare;
        }
        adjusted.edges[e].residual = edgeResidual(edge, *fit.poses[edge.to], *fit.poses[edge.from],
                                                  Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero())
                                         .value;
    }
    if (fit.degrees > 0) {
        adjusted.varianceFactor = fit.chiSquare / fit.degrees;
        adjusted.consistent = chiSquareTail(fit.chiSquare, fit.degrees) > kDisagreement;
    }
    if (!adjusted.consistent)
        for (auto& uncertainty : fit.uncertainty)
            if (uncertainty) uncertainty->covariance *= adjusted.varianceFactor;
    return adjusted;
}

}  // namespace vestige
