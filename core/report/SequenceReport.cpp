#include "core/report/SequenceReport.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/base/Version.h"
#include "core/evaluation/SizeComparison.h"
#include "core/report/PublishedTables.h"
#include "core/report/SequenceCharts.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

/// A line of a published table: which method and filter.
struct Line {
    std::string method;
    std::string filter;
};

std::vector<Line> linesOf(int table) {
    std::vector<Line> lines;
    for (const PublishedRow& row : publishedTable(table)) {
        const Line line{std::string(row.method), std::string(row.filter)};
        const bool known = std::any_of(lines.begin(), lines.end(), [&](const Line& one) {
            return one.method == line.method && one.filter == line.filter;
        });
        if (!known) lines.push_back(line);
    }
    return lines;
}

std::vector<double> voxelsOf(int table) {
    std::vector<double> voxels;
    for (const PublishedRow& row : publishedTable(table))
        if (std::find(voxels.begin(), voxels.end(), row.voxel_m) == voxels.end())
            voxels.push_back(row.voxel_m);
    return voxels;
}

/// One figure of each run beside its published counterpart, with the means over the sizes below.
Table besidePublished(int number, const std::vector<SequenceScore>& scores, const std::string& caption,
                      int decimals, const std::function<double(const SequenceScore&)>& here,
                      const std::function<double(const PublishedRow&)>& published) {
    const std::vector<Line> lines = linesOf(number);
    const std::vector<double> voxels = voxelsOf(number);
    Table table;
    table.caption = caption;
    table.columns = {"Voxel (m)"};
    std::vector<std::vector<std::optional<double>>> columns;
    for (const Line& line : lines) {
        const std::string name = seriesName(line.method, line.filter);
        std::vector<std::optional<double>> ours, theirs;
        for (const double voxel : voxels) {
            const SequenceScore* score = scoreOf(scores, line.method, line.filter, voxel);
            const auto row = publishedRow(number, line.method, line.filter, voxel);
            ours.push_back(score ? std::optional(here(*score)) : std::nullopt);
            if (published) theirs.push_back(row ? std::optional(published(*row)) : std::nullopt);
        }
        table.columns.push_back(name);
        columns.push_back(std::move(ours));
        if (!published) continue;
        table.columns.push_back("published");
        columns.push_back(std::move(theirs));
    }
    table.numeric.assign(table.columns.size(), true);
    const auto shown = [&](const std::optional<double>& value, std::size_t column) {
        const int digits = published && column % 2 == 1 ? 2 : decimals;
        return orDash(value ? std::optional(fixedText(*value, digits)) : std::nullopt);
    };
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        std::vector<std::string> row{fixedText(voxels[i], 1)};
        for (std::size_t c = 0; c < columns.size(); ++c) row.push_back(shown(columns[c][i], c));
        table.rows.push_back(std::move(row));
    }
    std::vector<std::string> means{"mean"};
    for (std::size_t c = 0; c < columns.size(); ++c) {
        double sum = 0;
        const bool whole = std::all_of(columns[c].begin(), columns[c].end(), [&](const auto& value) {
            sum += value.value_or(0);
            return value.has_value();
        });
        means.push_back(
            shown(whole ? std::optional(sum / static_cast<double>(voxels.size())) : std::nullopt, c));
    }
    table.emphasised.push_back(table.rows.size());
    table.rows.push_back(std::move(means));
    return table;
}

Section sequenceSection(const SequenceReportInput& input) {
    const SequenceExtent& extent = input.extent;
    Section section{"The sequence", {}};
    const std::size_t each = extent.points / std::max<std::size_t>(1, extent.clouds);
    Facts facts{{{"Clouds", std::to_string(extent.clouds)},
                 {"Points", grouped(extent.points) + ", " + grouped(each) + " a cloud"},
                 {"Way", fixedText(extent.path_m, 2) + " m along the known poses"},
                 {"Steps between clouds", "up to " + fixedText(extent.longestStep_m, 2) + " m and " +
                                              fixedText(degrees(extent.largestTurn_rad), 1) + "°"}}};
    const bool filtered = std::any_of(input.scores.begin(), input.scores.end(),
                                      [](const SequenceScore& score) { return score.filter != "none"; });
    if (filtered && !input.filterRadius.empty())
        facts.rows.emplace_back("Radius of the filters", input.filterRadius);
    if (!input.preset.empty()) facts.rows.emplace_back("Improved NDT, preset", input.preset);
    if (!input.processor.empty()) facts.rows.emplace_back("Processor", input.processor);
    facts.rows.emplace_back("Threads", std::to_string(input.threads));
    section.blocks.push_back(std::move(facts));
    section.blocks.push_back(Paragraph{
        "Each cloud is registered to the one before it, starting from no motion at all. With estimates P and "
        "known poses Q, E = (Q(i)⁻¹ Q(i+D))⁻¹ (P(i)⁻¹ P(i+D)) is the error of a relative pose, D = " +
        std::to_string(input.scores.empty() ? 1 : input.scores.front().distance) +
        "; the relative pose error (RPE) is the root mean square of the lengths of its translations, and its "
        "rotation part that of its angles. A pose counts whatever the registration says of it; where it "
        "gives "
        "none, the scanner counts as not moved."});
    return section;
}

Section tableSection(const SequenceReportInput& input, int number) {
    Section section{
        number == 2 ? "Table 2: classic and improved NDT" : "Table 3: filters before improved NDT", {}};
    section.blocks.push_back(Paragraph{
        "Published: Zhang, Guan, Liu, Zhang, World Electr. Veh. J. 2025, 16(3), 171, table " +
        std::to_string(number) +
        " (CC BY 4.0), measured on a pavilion sequence of the ETH ASL data sets on an i7-12900K. The figures "
        "beside them were measured here, on the sequence above and on this machine: the columns can be "
        "compared "
        "in their course, not in their size."});
    section.blocks.push_back(besidePublished(
        number, input.scores, "Relative pose error, translation (m)", 4,
        [](const SequenceScore& score) { return score.error.translation_m; },
        [](const PublishedRow& row) { return row.rpe_m; }));
    section.blocks.push_back(
        besidePublished(number, input.scores, "Relative pose error, rotation (°); not published", 3,
                        [](const SequenceScore& score) { return degrees(score.error.rotation_rad); }, {}));
    section.blocks.push_back(besidePublished(
        number, input.scores, "Time of registration (s), all pairs", 2,
        [](const SequenceScore& score) { return score.seconds; },
        [](const PublishedRow& row) { return row.seconds; }));
    if (const std::string words = conclusionOf(number, input.scores); !words.empty())
        section.blocks.push_back(Paragraph{words});
    std::vector<SequenceScore> shown;
    for (const SequenceScore& score : input.scores)
        if (score.voxel_m && publishedRow(number, score.method, score.filter, *score.voxel_m))
            shown.push_back(score);
    for (LineChart& chart : sequenceCharts(shown, number)) section.blocks.push_back(std::move(chart));
    return section;
}

Section allSection(const SequenceReportInput& input) {
    Table table;
    table.caption = "Every combination that was run";
    table.columns = {"Method",      "Filter",  "Voxel (m)",       "RPE (m)",  "median (m)",
                     "largest (m)", "RPE (°)", "Failed of pairs", "Time (s)", "Filtering (s)"};
    table.numeric = {false, false, true, true, true, true, true, true, true, true};
    for (const SequenceScore& score : input.scores)
        table.rows.push_back(
            {seriesName(score.method, "none"), score.filter,
             score.voxel_m ? exactText(*score.voxel_m) : "chosen", fixedText(score.error.translation_m, 4),
             fixedText(score.error.median.translation_m, 4), fixedText(score.error.largest.translation_m, 4),
             fixedText(degrees(score.error.rotation_rad), 3),
             std::to_string(score.failed) + " of " + std::to_string(score.pairs.size()),
             fixedText(score.seconds, 2), fixedText(score.preprocessSeconds, 2)});
    Section section{"All combinations", {std::move(table)}};
    if (input.tables.empty())
        for (LineChart& chart : sequenceCharts(input.scores)) section.blocks.push_back(std::move(chart));
    return section;
}

std::string filterConclusion(const std::vector<SequenceScore>& scores) {
    std::vector<std::string> lowest;
    for (const double voxel : voxelsOf(3)) {
        const SequenceScore* best = nullptr;
        for (const Line& line : linesOf(3)) {
            const SequenceScore* score = scoreOf(scores, line.method, line.filter, voxel);
            if (!score) return {};
            if (!best || score->error.translation_m < best->error.translation_m) best = score;
        }
        const SequenceScore* none = scoreOf(scores, best->method, "none", voxel);
        lowest.push_back(
            "at " + fixedText(voxel, 1) + " m " + best->filter + " (" +
            fixedText(1000 * best->error.translation_m, 1) + " mm" +
            (none ? ", unfiltered " + fixedText(1000 * none->error.translation_m, 1) + " mm" : "") + ")");
    }
    return "The filter with the lowest relative pose error is " + listed(lowest) +
           ". Published: gaussian at every size.";
}

}  // namespace

std::string conclusionOf(int table, const std::vector<SequenceScore>& scores) {
    if (table == 3) return filterConclusion(scores);
    const auto compared = compareBySize(scores, "improved-ndt", "ndt");
    if (table != 2 || !compared) return {};
    std::string text = "Improved NDT has the lower relative pose error at " +
                       std::to_string(compared->lower) + " of " + howMany(compared->sizes, "size") +
                       "; the mean over them is " + fixedText(1000 * compared->mean_m, 1) +
                       " mm, that of classic NDT " + fixedText(1000 * compared->otherMean_m, 1) + " mm. ";
    const double excess = 100 * (compared->worstRatio - 1);
    return text + "Where it compares worst, at " + exactText(compared->worstVoxel_m) + " m, it is " +
           fixedText(std::abs(excess), 1) + " % " + (excess > 0 ? "higher" : "lower") +
           ". Published: lower at 5 of 6 sizes.";
}

Report sequenceReport(const SequenceReportInput& input) {
    Report report;
    report.title = "Comparison of registration methods";
    report.subtitle = "Sequence " + input.name;
    report.date = readableDate(input.date);
    report.software = std::string("Vestige ") + kVersion;
    report.sections.push_back(sequenceSection(input));
    for (const int table : input.tables) report.sections.push_back(tableSection(input, table));
    report.sections.push_back(allSection(input));
    return report;
}

}  // namespace vestige
