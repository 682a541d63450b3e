#include "ui/print/PdfPrinter.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>

#include "core/base/AtomicFile.h"
#include "core/base/Translation.h"
#include "ui/print/BlockLayout.h"
#include "ui/print/PageFlow.h"
#include "ui/print/PdfIdentity.h"

namespace vestige {
namespace {

/// Case and report above, software and page number below, on every page.
void paintFrame(QPainter& painter, const PageStyle& style, const Report& report, std::size_t page,
                std::size_t pages) {
    const QFont font = style.font(7.8);
    const QFontMetricsF metrics(font);
    const double right = style.width - style.right;
    const auto ends = [&](double baseline, const QString& first, const QString& last) {
        const double room = style.textWidth() - metrics.horizontalAdvance(last) - dotsFromMm(6);
        painter.drawText(QPointF(style.left, baseline), metrics.elidedText(first, Qt::ElideRight, room));
        painter.drawText(QPointF(right - metrics.horizontalAdvance(last), baseline), last);
    };
    painter.setFont(font);
    painter.setPen(style.muted);
    const QString name = QString::fromStdString(report.caseName.empty() ? report.subtitle : report.caseName);
    ends(dotsFromMm(16), name, QString::fromStdString(report.title));
    ends(style.height - dotsFromMm(13), QString::fromStdString(report.software + " · " + report.date),
         QString::fromStdString(say("Page %1 of %2", {std::to_string(page + 1), std::to_string(pages)})));
    const double rule = dotsFromMm(0.15);
    painter.fillRect(QRectF(style.left, dotsFromMm(18), style.textWidth(), rule), style.rule);
    painter.fillRect(QRectF(style.left, style.height - dotsFromMm(17.5), style.textWidth(), rule),
                     style.rule);
}

Result<QByteArray> set(const Report& report, const JobControl& control) {
    const PageStyle style;
    PageFlow flow(style);
    layoutTitle(flow, report);
    int number = 0;
    for (const Section& section : report.sections) layoutSection(flow, section, ++number);

    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
    writer.setResolution(kDotsPerInch);
    writer.setTitle(
        QString::fromStdString(report.title + (report.caseName.empty() ? "" : ", " + report.caseName)));
    writer.setCreator(QString::fromStdString(report.software));
    QPainter painter;
    if (!painter.begin(&writer)) return fail(ErrorCode::output, "the PDF cannot be begun", "report");
    for (std::size_t page = 0; page < flow.pageCount(); ++page) {
        if (control.cancelled()) return fail(cancelledError());
        control.progress(static_cast<double>(page) / static_cast<double>(flow.pageCount()), "report");
        if (page > 0) writer.newPage();
        flow.paintPage(page, painter);
        paintFrame(painter, style, report, page, flow.pageCount());
    }
    if (!painter.end()) return fail(ErrorCode::output, "the PDF cannot be finished", "report");
    return withContentIdentity(bytes);
}

}  // namespace

std::string PdfPrinter::version() const {
    return std::string("Qt ") + qVersion();
}

Status PdfPrinter::printPdf(const Report& report, const std::filesystem::path& pdf,
                            const JobControl& control) {
    return guarded(pdf.string(), [&]() -> Status {
        const auto bytes = set(report, control);
        if (!bytes) return fail(bytes.error());
        return writeTextFile(pdf,
                             std::string_view(bytes->constData(), static_cast<std::size_t>(bytes->size())));
    });
}

}  // namespace vestige
