#include "ui/print/ChartFile.h"

#include <QBuffer>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>
#include <algorithm>
#include <string_view>

#include "core/base/AtomicFile.h"
#include "ui/charts/LineChart.h"
#include "ui/print/PageStyle.h"

namespace vestige {
namespace {

constexpr int kWidth = 1400;
constexpr int kChartHeight = 620;
constexpr int kMargin = 40;

void paint(QPainter& painter, std::span<const LineChart> charts) {
    QFont plain = PageStyle().font(10);
    plain.setPixelSize(22);
    const ChartStyle style = paperChartStyle(plain, 2);
    QRectF slot(0, 0, kWidth, kChartHeight);
    painter.fillRect(QRectF(0, 0, kWidth, kChartHeight * static_cast<double>(charts.size())), Qt::white);
    for (const LineChart& chart : charts) {
        const QRectF area = slot.adjusted(kMargin, kMargin, -kMargin, -kMargin);
        const double title = 1.8 * QFontMetricsF(style.font).height();
        QFont font = style.font;
        font.setWeight(QFont::DemiBold);
        painter.setFont(font);
        painter.setPen(style.text);
        painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, QString::fromStdString(chart.caption));
        paintLineChart(painter, area.adjusted(0, title, 0, 0), chart, style);
        slot.translate(0, kChartHeight);
    }
}

Result<QByteArray> svg(std::span<const LineChart> charts, const QSize& size) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size);
    generator.setViewBox(QRect(QPoint(0, 0), size));
    QPainter painter;
    if (!painter.begin(&generator)) return fail(ErrorCode::output, "the SVG cannot be begun");
    paint(painter, charts);
    painter.end();
    return bytes;
}

Result<QByteArray> png(std::span<const LineChart> charts, const QSize& size) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paint(painter, charts);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG")) return fail(ErrorCode::output, "the PNG cannot be made");
    return bytes;
}

QString extension(const std::filesystem::path& file) {
    return QString::fromStdString(file.extension().string()).toLower();
}

}  // namespace

bool isChartFile(const std::filesystem::path& file) {
    return extension(file) == QStringLiteral(".png") || extension(file) == QStringLiteral(".svg");
}

Status writeCharts(std::span<const LineChart> charts, const std::filesystem::path& file) {
    if (!isChartFile(file))
        return fail(ErrorCode::usage, "a chart cannot be written in this format", file.string(),
                    "expected .png or .svg");
    const QSize size(kWidth, kChartHeight * std::max<int>(1, static_cast<int>(charts.size())));
    const Result<QByteArray> bytes =
        extension(file) == QStringLiteral(".svg") ? svg(charts, size) : png(charts, size);
    if (!bytes) return fail(bytes.error());
    return writeTextFile(file, std::string_view(bytes->constData(), static_cast<std::size_t>(bytes->size())));
}

}  // namespace vestige
