#include "app/cli/EvaluateOutputs.h"

#include <array>
#include <optional>
#include <vector>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/AtomicFile.h"
#include "core/base/Translation.h"
#include "core/base/UtcTime.h"
#include "core/evaluation/SequenceCsv.h"
#include "core/report/SequenceCharts.h"
#include "core/report/TranslateReport.h"
#include "ui/print/ChartFile.h"
#include "ui/print/PdfPrinter.h"

namespace vestige::cli {
namespace {

/// A file that waits under its temporary name until all others stand.
class Waiting {
  public:
    explicit Waiting(const std::string& place) {
        if (!place.empty()) file_.emplace(place);
    }
    bool wanted() const { return file_.has_value(); }
    Status write(const std::string& text) {
        if (!file_) return {};
        if (const Status opened = file_->open(); !opened) return opened;
        file_->write(text);
        return {};
    }
    /// For writers that take a path and replace the file at once.
    const std::filesystem::path& path() const { return file_->temporaryPath(); }
    AtomicFile* file() { return file_ ? &*file_ : nullptr; }

  private:
    std::optional<AtomicFile> file_;
};

}  // namespace

Status checkOutputs(const EvaluateOutputs& outputs) {
    if (!outputs.chart.empty() && !isChartFile(outputs.chart))
        return fail(ErrorCode::usage, "a chart cannot be written in this format", outputs.chart,
                    "expected .png or .svg");
    const std::array<const std::string*, 4> places{&outputs.csv, &outputs.pairs, &outputs.chart,
                                                   &outputs.pdf};
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (samePlace(*places[i], *places[j]))
                return fail(ErrorCode::usage, "two outputs name the same file", *places[i],
                            "a file for each of --out, --pairs, --chart and --pdf is expected");
    return {};
}

Status writeOutputs(const EvaluateOutputs& outputs, SequenceReportInput found, const JobControl& control) {
    found.date = utcNow();
    Waiting csv(outputs.csv), pairs(outputs.pairs), chart(outputs.chart), pdf(outputs.pdf);
    for (const Status& written : {csv.write(sequenceCsv(found.scores)), pairs.write(pairsCsv(found.scores)),
                                  chart.write({}), pdf.write({})})
        if (!written) return written;
    if (chart.wanted() || pdf.wanted()) {
        const OffscreenApplication application;
        if (chart.wanted())
            if (const Status drawn = writeCharts(sequenceCharts(found.scores), chart.path()); !drawn)
                return drawn;
        if (pdf.wanted())
            if (const Status set =
                    PdfPrinter().printPdf(translated(sequenceReport(found), language()), pdf.path(), control);
                !set)
                return set;
    }
    std::vector<AtomicFile*> files;
    for (Waiting* one : {&csv, &pairs, &chart, &pdf})
        if (one->wanted()) files.push_back(one->file());
    return AtomicFile::commit(files);
}

}  // namespace vestige::cli
