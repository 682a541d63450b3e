#pragma once

#include <string>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/report/SequenceReport.h"

namespace vestige::cli {

/// Files that `evaluate` writes; empty ones are not asked for.
struct EvaluateOutputs {
    std::string csv;
    std::string pairs;
    std::string chart;
    std::string pdf;
};

/// ErrorCode::usage where one of them cannot be written by its name.
Status checkOutputs(const EvaluateOutputs& outputs);

/// All or none; `found.date` is set to now. ErrorCode::output.
Status writeOutputs(const EvaluateOutputs& outputs, SequenceReportInput found, const JobControl& control);

}  // namespace vestige::cli
