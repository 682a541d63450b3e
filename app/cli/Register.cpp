#include "core/registration/Register.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/FilePart.h"
#include "app/cli/Outputs.h"
#include "app/cli/Session.h"
#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/io/FormatRegistry.h"
#include "core/io/IntoMetres.h"
#include "core/registration/InitialPose.h"
#include "core/registration/RegistrationJson.h"
#include "core/registration/global/FirstPose.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string target;
    FilePart part;
    std::string source;
    std::string poseOut;
    std::string init = "identity";
    std::string unit = "auto";
    std::string aligned;
    ParameterSet parameters{registrationParameters()};
    ReadOptions reading;
};

/// Where the source starts from, and what the user should know about it.
struct Start {
    Similarity pose;
    std::optional<double> error_m;  ///< of picked pairs, or of what the search found
    std::vector<std::string> notes;
    std::optional<FirstPose> found;  ///< by the search
};

/// The unit that --unit names, else the one that pairs, the file or the clouds speak for.
double scaleOf(const Options& options, const TriangleMesh& target, const LoadedGeometry& source,
               std::span<const PointPair> pairs, std::vector<std::string>& notes) {
    if (const auto unit = lengthUnitFromSymbol(options.unit)) return metresPer(*unit);
    const UnitGuess guess = guessUnit(target, 1, source.geometry, pairs, source.info.metresPerUnit);
    if (guess.metresPerUnit != 1 || !guess.certain)
        notes.push_back(guess.reason + (guess.certain ? "" : " (not certain: say --unit m or --unit mm)"));
    return guess.metresPerUnit;
}

/// `target` in metres; picked pairs have its points in its file's unit, `metresPerTarget` of it.
Result<Start> startFrom(const Options& options, const TriangleMesh& target, double metresPerTarget,
                        const LoadedGeometry& source, const JobControl& control) {
    Start start;
    if (options.init == "auto") {
        const auto given = lengthUnitFromSymbol(options.unit);
        Result<FirstPose> found =
            findFirstPose(target, source.geometry, given ? metresPer(*given) : source.info.metresPerUnit,
                          options.parameters, control);
        if (!found) return fail(found.error());
        start.pose = found->targetFromSource;
        start.error_m = found->error_m;
        start.found = std::move(*found);
        return start;
    }
    if (options.init == "identity") {
        start.pose.scale = scaleOf(options, target, source, {}, start.notes);
        return start;
    }
    if (!options.init.ends_with(".csv")) {
        const Result<Similarity> pose = readPoseFile(options.init);
        if (!pose) return fail(pose.error());
        start.pose = *pose;
        if (const auto unit = lengthUnitFromSymbol(options.unit)) start.pose.scale = metresPer(*unit);
        return start;
    }
    Result<std::vector<PointPair>> pairs = readPointPairs(options.init);
    if (!pairs) return fail(pairs.error());
    for (PointPair& pair : *pairs) pair.target *= metresPerTarget;
    const double scale = scaleOf(options, target, source, *pairs, start.notes);
    const Result<PairAlignment> alignment = alignPairs(*pairs, scale);
    if (!alignment) {
        Error error = alignment.error();
        error.place = options.init;
        return fail(std::move(error));
    }
    start.pose = alignment->targetFromSource;
    start.error_m = alignment->error_m;
    std::string residuals;
    for (const double residual : alignment->residuals_m) residuals += " " + fixedText(residual, 4);
    start.notes.push_back("First pose from " + std::to_string(pairs->size()) +
                          " pairs, residuals in m:" + residuals);
    return start;
}

/// All outputs or none.
Status writeOutputs(const Options& options, const FileInfo& target, LoadedGeometry source,
                    const Similarity& pose, const JobControl& control) {
    AtomicFile poseFile(options.poseOut);
    if (const Status opened = poseFile.open(); !opened) return opened;
    poseFile.write(poseFileText(pose));
    if (options.aligned.empty()) return poseFile.commit();
    AtomicFile aligned(options.aligned);
    if (const Status opened = aligned.open(); !opened) return opened;
    moveIntoMetres(source, pose);
    if (target.metresPerUnit.value_or(1) == 1) {
        source.info.crs = target.crs;
        source.info.crsRecords = target.crsRecords;
    }
    Status written = writeGeometry(aligned.temporaryPath(), source.geometry, {&source.info}, control);
    if (!written && written.error().place == aligned.temporaryPath()) written.error().place = options.aligned;
    if (!written) return written;
    return AtomicFile::commit({&poseFile, &aligned});
}

void report(const Session& session, const Options& options, const RegistrationResult& result) {
    for (const std::string& note : result.notes) session.log(note);
    if (result.verdict == Verdict::doubtful)
        for (const std::string& reason : result.reasons) session.log("warning: doubtful: " + reason);
    else
        for (const std::string& reason : result.reasons) session.log(reason);
    session.print("pose written to " + options.poseOut);
    session.print("overlap " + fixedText(100 * result.overlap, 1) + " %, RMSE " +
                  fixedText(1000 * result.rmse_m, 1) + " mm, " + std::to_string(result.iterations) +
                  " iterations in " + fixedText(result.seconds, 2) + " s");
}

/// Where nothing was found that could be registered, --json says so, too.
int failed(const Session& session, const Options& options, const Error& error,
           const std::vector<PoseCandidate>& candidates) {
    if (error.code == ErrorCode::untrustworthy)
        session.printJson(failedRegistrationJson(options.parameters.text("method"), error, candidates));
    return session.failed(error);
}

int runRegister(Session& session, const Options& options) {
    if (samePlace(options.poseOut, options.aligned))
        return session.failed({ErrorCode::usage, "--pose-out and --aligned name the same file",
                               options.poseOut, "a file for each is expected"});
    if (const Status apart = noInputIsWritten({options.poseOut, options.aligned},
                                              {options.target, options.source, options.init});
        !apart)
        return session.failed(apart.error());
    if (!options.aligned.empty())
        if (const auto format = formatForWriting(options.aligned); !format)
            return session.failed(format.error());
    const JobControl& control = session.control();
    Result<LoadedGeometry> target = readPart(options.target, options.part, ReadOptions::Attributes::drawn,
                                             LoadedFor::metres, control.sub(0, 0.2));
    if (!target) return session.failed(target.error());
    const double metresPerTarget = target->info.metresPerUnit.value_or(1);
    if (metresPerTarget != 1) {
        target->geometry = std::move(target->geometry).transformed({Pose::Identity(), metresPerTarget});
        session.log(options.target + " has " + exactText(metresPerTarget) +
                    " m a unit, as it says; the pose leads into its frame in metres");
    }
    Result<LoadedGeometry> source =
        readPart(options.source, {options.part.every, std::nullopt, options.part.salvage},
                 options.aligned.empty() ? ReadOptions::Attributes::drawn : ReadOptions::Attributes::all,
                 options.aligned.empty() ? LoadedFor::command : LoadedFor::moving, control.sub(0.2, 0.4));
    if (!source) return session.failed(source.error());
    for (const LoadedGeometry* loaded : std::initializer_list<const LoadedGeometry*>{&*target, &*source})
        if (!loaded->info.damage.empty())
            session.log("warning: " + loaded->info.path.string() + ": " + loaded->info.damage);
    const Result<Start> start =
        startFrom(options, target->geometry, metresPerTarget, *source, control.sub(0.4, 0.6));
    if (!start) return failed(session, options, start.error(), {});
    ParameterSet parameters = options.parameters;
    if (start->error_m && parameters.isDefault("start_error_m"))
        parameters.setNearest("start_error_m", *start->error_m);
    Result<RegistrationResult> result = attemptRegistration(target->geometry, source->geometry, start->pose,
                                                            parameters, control.sub(0.6, 0.95));
    if (!result)
        return failed(session, options, result.error(),
                      start->found ? start->found->candidates : std::vector<PoseCandidate>{});
    result->notes.insert(result->notes.begin(), start->notes.begin(), start->notes.end());
    if (start->found) addFirstPose(*result, *start->found);
    if (!result->trustworthy()) {
        session.printJson(registrationJson(*result, true));
        for (const std::string& note : result->notes) session.log(note);
        Error error{ErrorCode::untrustworthy, result->reasons.front(), options.source,
                    "nothing was written; check that the clouds show the same place, and give a nearer "
                    "first pose (--init)"};
        return session.failed(error);
    }
    const Status written = writeOutputs(options, target->info, std::move(*source), result->targetFromSource,
                                        control.sub(0.95, 1));
    if (!written) return session.failed(written.error());
    control.progress(1, "registration");
    report(session, options, *result);
    session.printJson(registrationJson(*result, true));
    return 0;
}

}  // namespace

Run declareRegister(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command
        .add_option("TARGET", options->target,
                    "Cloud or mesh that stays, in metres unless it says another unit")
        ->required();
    command.add_option("SOURCE", options->source, "Cloud or mesh that is laid on the target")->required();
    command.add_option("--pose-out", options->poseOut, "JSON file for the pose that maps SOURCE into TARGET")
        ->required();
    command.add_option("--init", options->init,
                       "First pose: identity, auto (searched), a pose file (.json) or picked pairs (.csv). "
                       "Default: identity.");
    command
        .add_option("--unit", options->unit,
                    "Unit of SOURCE: " + lengthUnitSymbols() + " or auto. Default: auto.")
        ->check([](const std::string& text) {
            return text == "auto" || lengthUnitFromSymbol(text)
                       ? std::string()
                       : "expected " + lengthUnitSymbols() + " or auto";
        });
    command.add_option("--aligned", options->aligned, "File for the source's points in the target's frame");
    addPartOptions(command, options->part, "TARGET");
    addParameterOptions(command, options->parameters);
    return [options](Session& session) { return runRegister(session, *options); };
}

}  // namespace vestige::cli
