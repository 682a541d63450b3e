#include "core/report/AccuracyReport.h"
#include "core/report/CaseReport.h"

namespace vestige {

Section accuracySection(const ReportInput& input) {
    return {"Accuracy against the tape", accuracyBlocks(input.measured.accuracy)};
}

}  // namespace vestige
