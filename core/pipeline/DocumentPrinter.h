#pragma once

#include <filesystem>
#include <string>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/report/Section.h"

namespace vestige {

/// Sets a report as PDF/A-1b; ui/print implements it, both mains hand it to the pipeline.
class DocumentPrinter {
  public:
    virtual ~DocumentPrinter() = default;
    /// Atomic; ErrorCode::output on failure.
    virtual Status printPdf(const Report& report, const std::filesystem::path& pdf,
                            const JobControl& control) = 0;
    /// What sets the pages, for the report: "Qt 5.15.8".
    virtual std::string version() const { return {}; }
};

}  // namespace vestige
