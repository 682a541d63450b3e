#pragma once

#include "core/pipeline/DocumentPrinter.h"

namespace vestige {

/// Sets reports on A4 with QPdfWriter: PDF/A-1b, fonts embedded, sRGB, nothing translucent, pictures without
/// loss. A QGuiApplication must exist (the offscreen platform will do).
class PdfPrinter : public DocumentPrinter {
  public:
    std::string version() const override;
    Status printPdf(const Report& report, const std::filesystem::path& pdf,
                    const JobControl& control) override;
};

}  // namespace vestige
