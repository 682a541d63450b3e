#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/Session.h"
#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/evaluation/SequenceEvaluation.h"
#include "core/filters/Preprocess.h"
#include "core/registration/Register.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string folder;
    std::string truth;
    std::string out;
    std::vector<std::string> methods;
    std::vector<std::string> voxels;
    std::vector<std::string> filters;
};

/// One run of the comparison.
struct Combination {
    ParameterSet preprocessing{preprocessParameters()};
    ParameterSet registration{registrationParameters()};
};

Result<std::vector<Combination>> combinations(const Options& options) {
    std::vector<Combination> all;
    for (const std::string& filter : options.filters)
        for (const std::string& method : options.methods)
            for (const std::string& voxel : options.voxels) {
                Combination one;
                for (const Status& set : {one.preprocessing.setFromText("filter", filter),
                                          one.registration.setFromText("method", method),
                                          one.registration.setFromText("voxel_m", voxel)})
                    if (!set) return fail(set.error());
                all.push_back(std::move(one));
            }
    return all;
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
                          {"preprocess_seconds", score.preprocessSeconds}};
    if (const auto voxel = parseReal(score.voxel)) object["voxel_m"] = *voxel;
    return object;
}

int runEvaluate(Session& session, const Options& options) {
    const Result<std::vector<Combination>> runs = combinations(options);
    if (!runs) return session.failed(runs.error());
    const Result<Sequence> sequence =
        readSequence(options.folder, options.truth, session.control().sub(0, 0.2));
    if (!sequence) return session.failed(sequence.error());
    std::vector<SequenceScore> scores;
    nlohmann::json rows = nlohmann::json::array();
    for (const Combination& run : *runs) {
        const double from =
            0.2 + 0.8 * static_cast<double>(scores.size()) / static_cast<double>(runs->size());
        const double to = from + 0.8 / static_cast<double>(runs->size());
        const Result<SequenceScore> score =
            evaluateSequence(*sequence, run.preprocessing, run.registration, session.control().sub(from, to));
        if (!score) return session.failed(score.error());
        scores.push_back(*score);
        rows.push_back(jsonOf(*score));
        session.print(score->method + ", voxel " + score->voxel + ", filter " + score->filter + ": RPE " +
                      fixedText(score->error.translation_m, 4) + " m, " +
                      fixedText(degrees(score->error.rotation_rad), 3) + " deg, " +
                      fixedText(score->seconds, 2) + " s, " + std::to_string(score->failed) + " of " +
                      std::to_string(score->error.pairs) + " failed");
    }
    if (const Status written = writeTextFile(options.out, sequenceCsv(scores)); !written)
        return session.failed(written.error());
    session.printJson({{"rows", rows}});
    return 0;
}

}  // namespace

Run declareEvaluate(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("DIR", options->folder, "Folder with the clouds of a sequence")->required();
    command.add_option("--truth", options->truth, "ASL pose CSV, or lines t x y z qx qy qz qw")->required();
    command.add_option("--out", options->out, "CSV with a row per combination")->required();
    const auto repeated = [&](const char* name, std::vector<std::string>& values, const char* standard,
                              const char* help) {
        command.add_option(name, values, help)
            ->default_val(std::vector<std::string>{standard})
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    repeated("--method", options->methods, "improved-ndt", "improved-ndt, ndt or icp; may be repeated");
    repeated("--voxel", options->voxels, "auto", "Smallest voxel in m, or auto; may be repeated");
    repeated("--filter", options->filters, "none", "none, mean, median or gaussian; may be repeated");
    return [options](Session& session) { return runEvaluate(session, *options); };
}

}  // namespace vestige::cli
