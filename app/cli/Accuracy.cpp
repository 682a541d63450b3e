#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/Outputs.h"
#include "app/cli/Session.h"
#include "app/offscreen/OffscreenApplication.h"
#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"
#include "core/base/Translation.h"
#include "core/base/UtcTime.h"
#include "core/measurement/AccuracyTable.h"
#include "core/report/AccuracyCsv.h"
#include "core/report/AccuracyReport.h"
#include "core/report/ResultsJson.h"
#include "core/report/TranslateReport.h"
#include "core/report/Wording.h"
#include "ui/print/PdfPrinter.h"

namespace vestige::cli {
namespace {

struct Options {
    std::string table;
    std::string csv;
    std::string pdf;
};

/// Both outputs or none.
Status writeOutputs(const std::vector<MethodAccuracy>& methods, const Options& options,
                    const JobControl& control) {
    AtomicFile csv(options.csv), pdf(options.pdf);
    std::vector<AtomicFile*> files;
    if (!options.csv.empty()) {
        if (auto opened = csv.open(); !opened) return opened;
        csv.write(accuracyCsv(methods));
        files.push_back(&csv);
    }
    if (!options.pdf.empty()) {
        if (auto opened = pdf.open(); !opened) return opened;
        const OffscreenApplication application;
        const std::string name = std::filesystem::path(options.table).filename().string();
        if (auto printed =
                PdfPrinter().printPdf(translated(accuracyReport(methods, name, utcNow()), language()),
                                      pdf.temporaryPath(), control);
            !printed)
            return printed;
        files.push_back(&pdf);
    }
    return AtomicFile::commit(files);
}

void printForPeople(const Session& session, const MethodAccuracy& method) {
    const auto percent = [](const std::optional<double>& fraction) {
        return fraction ? fixedText(100 * *fraction, 2) + " %" : std::string("none");
    };
    session.print(
        method.name + ": " + howMany(method.n, "object") + ", SD " + percent(method.sd) + ", RMSE " +
        percent(method.rmse) + ", RMSE of all " + percent(method.rmseAll) +
        (method.rmseAbsolute_m ? ", of all in metres " + fixedText(*method.rmseAbsolute_m, 4) : ""));
    if (!method.excluded.empty()) session.print("  excluded: " + listed(method.excluded));
    if (method.systematic)
        session.print("  none excluded: the errors are systematic, their mean is " +
                      signedPercent(method.meanRe) + " %");
}

int run(Session& session, const Options& options) {
    if (samePlace(options.csv, options.pdf))
        return session.failed({ErrorCode::usage, "--out and --pdf name the same file", options.csv,
                               "a file for each is expected"});
    if (const Status apart = noInputIsWritten({options.csv, options.pdf}, {options.table}); !apart)
        return session.failed(apart.error());
    const auto methods = readAccuracyTable(options.table);
    if (!methods) return session.failed(methods.error());
    if (const Status written = writeOutputs(*methods, options, session.control()); !written)
        return session.failed(written.error());
    for (const auto& method : *methods) printForPeople(session, method);
    session.printJson({{"methods", accuracyJson(*methods)}});
    return 0;
}

}  // namespace

Run declareAccuracy(CLI::App& command) {
    const auto options = std::make_shared<Options>();
    command
        .add_option(
            "TABLE", options->table,
            "CSV with the columns object,tape_m,<name>_m,...: taped and measured lengths in metres, a "
            "row per object; an empty cell is not measured.")
        ->required();
    command
        .add_option("--out", options->csv,
                    "The statistics as CSV: method,n,sd,rmse,rmse_all,rmse_abs_m,excluded,"
                    "rmse_large,small.")
        ->type_name("CSV");
    command.add_option("--pdf", options->pdf, "A report with tables and bar chart.")->type_name("PDF");
    return [options](Session& session) { return run(session, *options); };
}

}  // namespace vestige::cli
