#pragma once

#include "core/report/ReportInput.h"
#include "core/report/Section.h"

namespace vestige {

/// The sections of a case's report, each in its own pair of files. Nothing: the section has nothing to say.
Section summarySection(const ReportInput& input);
Section caseSection(const ReportInput& input);
Section inputSection(const ReportInput& input);
Section cleaningSection(const ReportInput& input);
Section methodSection(const ReportInput& input);
Section registrationSection(const ReportInput& input);
Section lengthSection(const ReportInput& input);
Section kindSection(const ReportInput& input);
Section checkSection(const ReportInput& input);
Section accuracySection(const ReportInput& input);
Section uncertaintySection(const ReportInput& input);
Section notesSection(const ReportInput& input);
Section originSection(const ReportInput& input);

/// The report of a case: every section that has content, in the order of the list in the implementation.
Report caseReport(const ReportInput& input);

}  // namespace vestige
