#pragma once

#include <QByteArray>
#include <filesystem>
#include <vector>

namespace vestige::test {

/// One indirect object of a PDF: its dictionary as text, and its stream, inflated.
struct PdfObject {
    QByteArray dictionary;
    QByteArray stream;
};

/// The objects of a PDF as QPdfWriter writes it (no object streams).
std::vector<PdfObject> readPdf(const std::filesystem::path& file);

}  // namespace vestige::test
