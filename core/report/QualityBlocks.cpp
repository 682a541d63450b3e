#include "core/report/QualityBlocks.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

constexpr double kNormal95 = 1.96;  // of one direction: the worst one is given

std::string millimetres(double metres) {
    return fixedText(1000 * metres, 1) + " mm";
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += (text.empty() ? "" : "; ") + sentence;
    return text;
}

double largestSigma(const Eigen::Matrix3d& covariance) {
    return std::sqrt(
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance, Eigen::EigenvaluesOnly).eigenvalues()[2]);
}

std::string freeWords(const RegistrationQuality& quality) {
    std::vector<std::string> words;
    for (const ObservedDirection& direction : quality.directions)
        if (direction.free) words.push_back("it " + direction.words);
    return words.empty() ? "held in every direction" : "not held: " + joined(words);
}

Facts facts(const RegistrationResult& result) {
    Facts facts{{{"Verdict", std::string(describe(result.verdict))}}};
    if (!result.reasons.empty()) facts.rows.emplace_back("Why", joined(result.reasons));
    if (!result.quality) return facts;
    const RegistrationQuality& quality = *result.quality;
    const Matrix6d& covariance = quality.uncertainty.covariance;
    facts.rows.emplace_back("Uncertainty of the place (95 %)",
                            millimetres(kNormal95 * largestSigma(covariance.topLeftCorner<3, 3>())) +
                                " at the scan's middle, in the worst direction");
    facts.rows.emplace_back(
        "Uncertainty of the turn (95 %)",
        fixedText(degrees(kNormal95 * largestSigma(covariance.bottomRightCorner<3, 3>())), 4) +
            "\u00b0 about the worst axis");
    facts.rows.emplace_back("Hold", freeWords(quality));
    facts.rows.emplace_back("Distance to local planes",
                            millimetres(quality.planeRmse_m) + " (root mean square)");
    if (quality.restarts.runs > 0)
        facts.rows.emplace_back(
            "Restarts", std::to_string(quality.restarts.agreeing) + " of " +
                            howMany(static_cast<std::size_t>(quality.restarts.runs), "perturbed start") +
                            " came back, within " + millimetres(quality.restarts.translation_m) + " and " +
                            fixedText(degrees(quality.restarts.rotation_rad), 4) + "\u00b0");
    return facts;
}

/// Only bins up to the last that hold one in a thousand; what lies beyond is summed up.
Table residualTable(const ResidualHistogram& histogram) {
    std::size_t total = histogram.outside;
    for (const std::size_t count : histogram.counts) total += count;
    const std::size_t middle = histogram.counts.size() / 2;
    const auto pairAt = [&](std::size_t i) {
        return i == 0 ? histogram.counts[middle]
                      : histogram.counts[middle - i] + histogram.counts[middle + i];
    };
    std::size_t last = middle;
    while (last > 0 && 1000 * pairAt(last) < total) --last;
    Table table;
    table.caption = "Distances of the scan's points to the local planes of the global cloud";
    table.columns = {"Distance (mm)", "Below the plane", "Above the plane", "Share"};
    table.numeric = {true, true, true, true};
    std::size_t shown = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const double from = std::max(0.0, (static_cast<double>(i) - 0.5) * histogram.width_m);
        const double to = (static_cast<double>(i) + 0.5) * histogram.width_m;
        shown += pairAt(i);
        table.rows.push_back({fixedText(1000 * from, 2) + " to " + fixedText(1000 * to, 2),
                              i == 0 ? "" : std::to_string(histogram.counts[middle - i]),
                              i == 0 ? "" : std::to_string(histogram.counts[middle + i]),
                              percent(static_cast<double>(pairAt(i)) / static_cast<double>(total))});
    }
    table.rows.push_back(
        {"more", "", "", percent(static_cast<double>(total - shown) / static_cast<double>(total))});
    return table;
}

}  // namespace

std::vector<Block> qualityBlocks(const RegistrationResult& result) {
    std::vector<Block> blocks{facts(result)};
    if (!result.quality) return blocks;
    const ResidualHistogram& histogram = result.quality->residuals;
    std::size_t total = histogram.outside;
    for (const std::size_t count : histogram.counts) total += count;
    if (total > 0 && !histogram.counts.empty()) blocks.emplace_back(residualTable(histogram));
    return blocks;
}

}  // namespace vestige
