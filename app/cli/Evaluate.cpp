#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/EvaluateOutputs.h"
#include "app/cli/Session.h"
#include "core/base/Numbers.h"
#include "core/base/Parallel.h"
#include "core/base/Processor.h"
#include "core/base/Units.h"
#include "core/evaluation/EvaluationPlan.h"
#include "core/filters/Preprocess.h"
#include "core/report/Wording.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string folder;
    std::string truth;
    std::string frame = "auto";
    std::vector<std::string> methods;
    std::vector<std::string> voxels;
    std::vector<std::string> filters;
    std::vector<int> tables;
    std::size_t delta = 1;
    ParameterSet preprocessing{preprocessParameters()};
    ParameterSet registration{comparedRegistration()};
    EvaluateOutputs outputs;
};

/// The published tables asked for, and the combinations asked for by hand; without either, what is usual.
std::vector<EvaluationChoice> choicesOf(const Options& options) {
    std::vector<EvaluationChoice> choices;
    for (const int table : options.tables) choices.push_back(publishedChoice(table));
    const bool byHand = !options.methods.empty() || !options.voxels.empty() || !options.filters.empty();
    if (!byHand && !choices.empty()) return choices;
    const auto orElse = [](const std::vector<std::string>& given, const char* standard) {
        return given.empty() ? std::vector<std::string>{standard} : given;
    };
    choices.push_back({orElse(options.methods, "improved-ndt"), orElse(options.voxels, "auto"),
                       orElse(options.filters, "none")});
    return choices;
}

nlohmann::json jsonOf(const SequenceScore& score) {
    nlohmann::json object{{"method", score.method},
                          {"voxel_m", nullptr},
                          {"filter", score.filter},
                          {"pairs", score.error.pairs},
                          {"failed", score.failed},
                          {"rpe_m", score.error.translation_m},
                          {"rpe_deg", degrees(score.error.rotation_rad)},
                          {"seconds", score.seconds},
                          {"preprocess_seconds", score.preprocessSeconds},
                          {"delta", score.distance},
                          {"rpe_median_m", score.error.median.translation_m},
                          {"rpe_max_m", score.error.largest.translation_m},
                          {"rpe_median_deg", degrees(score.error.median.rotation_rad)},
                          {"rpe_max_deg", degrees(score.error.largest.rotation_rad)}};
    if (score.voxel_m) object["voxel_m"] = *score.voxel_m;
    return object;
}

void printForPeople(const Session& session, const SequenceScore& score) {
    session.print(score.method + ", voxel " + (score.voxel_m ? exactText(*score.voxel_m) : "auto") +
                  ", filter " + score.filter + ": RPE " + fixedText(score.error.translation_m, 4) + " m, " +
                  fixedText(degrees(score.error.rotation_rad), 3) + " deg, " + fixedText(score.seconds, 2) +
                  " s, " + std::to_string(score.failed) + " of " + std::to_string(score.pairs.size()) +
                  " failed");
}

SequenceFrame frameOf(const std::string& name) {
    if (name == "auto") return SequenceFrame::byName;
    return name == "world" ? SequenceFrame::world : SequenceFrame::scanner;
}

int runEvaluate(Session& session, const Options& options) {
    if (const Status checked = checkOutputs(options.outputs); !checked)
        return session.failed(checked.error());
    const Result<std::vector<EvaluationRun>> runs =
        evaluationRuns(choicesOf(options), options.preprocessing, options.registration);
    if (!runs) return session.failed(runs.error());
    const Result<Sequence> sequence =
        readSequence(options.folder, options.truth, frameOf(options.frame), session.control().sub(0, 0.1));
    if (!sequence) return session.failed(sequence.error());
    if (options.delta >= sequence->clouds.size())
        return session.failed({ErrorCode::usage, "no two clouds are that far apart", "--delta",
                               "expected 1 to " + std::to_string(sequence->clouds.size() - 1)});
    SequenceReportInput found;
    found.name = std::filesystem::weakly_canonical(options.folder).filename().string();
    found.extent = extentOf(*sequence);
    found.tables = options.tables;
    found.threads = threadCount();
    found.processor = processorName();
    found.preset = options.registration.text("preset");
    found.filterRadius = options.preprocessing.optionalReal("radius_m")
                             ? options.preprocessing.display("radius_m")
                             : "3 times the median spacing of each cloud";
    const double share = 0.85 / static_cast<double>(runs->size());
    nlohmann::json rows = nlohmann::json::array();
    for (const EvaluationRun& run : *runs) {
        const double from = 0.1 + share * static_cast<double>(found.scores.size());
        Result<SequenceScore> score =
            evaluateSequence(*sequence, run.preprocessing, run.registration, options.delta,
                             session.control().sub(from, from + share));
        if (!score) return session.failed(score.error());
        printForPeople(session, *score);
        rows.push_back(jsonOf(*score));
        found.scores.push_back(std::move(*score));
    }
    if (const Status written = writeOutputs(options.outputs, found, session.control().sub(0.95, 1)); !written)
        return session.failed(written.error());
    for (const int table : options.tables) session.print(conclusionOf(table, found.scores));
    session.printJson({{"clouds", found.extent.clouds}, {"points", found.extent.points}, {"rows", rows}});
    return 0;
}

void addOutputs(CLI::App& command, EvaluateOutputs& outputs) {
    command.add_option("--out", outputs.csv, "CSV with a row per combination")->required()->type_name("CSV");
    command.add_option("--pairs", outputs.pairs, "CSV with a row per combination and pair of neighbours")
        ->type_name("CSV");
    command.add_option("--chart", outputs.chart, "RPE and time by voxel as a picture, .png or .svg")
        ->type_name("FILE");
    command.add_option("--pdf", outputs.pdf, "A report with tables and charts")->type_name("PDF");
}

}  // namespace

Run declareEvaluate(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("DIR", options->folder, "Folder with the clouds of a sequence")->required();
    command.add_option("--truth", options->truth, "ASL pose CSV, or lines t x y z qx qy qz qw")->required();
    addOutputs(command, options->outputs);
    const auto repeated = [&](const char* name, auto& values, const char* help) {
        return command.add_option(name, values, help)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    repeated("--method", options->methods,
             "improved-ndt, ndt or icp; may be repeated. Default: improved-ndt.");
    repeated("--voxel", options->voxels, "Smallest voxel in m, or auto; may be repeated. Default: auto.");
    repeated("--filter", options->filters, "none, mean, median or gaussian; may be repeated. Default: none.");
    repeated(
        "--table", options->tables,
        "2 or 3: the combinations of that table of the publication; may be repeated, and the report shows "
        "it beside the published figures. --method, --voxel and --filter add to it.")
        ->check(CLI::IsMember({2, 3}));
    command.add_option("--delta", options->delta, "Compared are poses this many clouds apart. Default: 1.")
        ->check(CLI::Range(1, 1000000));
    command
        .add_option("--frame", options->frame,
                    "What the clouds stand in: their scanner's frame, the world of the known poses, or auto: "
                    "the latter for PointCloudN.csv alone. Default: auto.")
        ->check(CLI::IsMember({"auto", "scanner", "world"}));
    command
        .add_option_function<std::string>(
            "--radius",
            [options](const std::string& text) {
                if (const Status set = options->preprocessing.setFromText("radius_m", text); !set)
                    throw CLI::ValidationError("--radius", set.error().sentence());
            },
            "Radius of the filters. Default: 3 times the median spacing of each cloud.")
        ->type_name("m");
    command
        .add_option_function<std::string>(
            "--preset",
            [options](const std::string& text) {
                if (const Status set = options->registration.setFromText("preset", text); !set)
                    throw CLI::ValidationError("--preset", set.error().sentence());
            },
            "Improved NDT as it is here (default) or as published (paper).")
        ->type_name("VALUE");
    return [options](Session& session) { return runEvaluate(session, *options); };
}

}  // namespace vestige::cli
