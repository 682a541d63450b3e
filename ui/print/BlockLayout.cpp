#include "ui/print/BlockLayout.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <functional>
#include <memory>

#include "core/base/Result.h"
#include "core/base/Translation.h"
#include "ui/charts/DiagramChart.h"
#include "ui/charts/LineChart.h"
#include "ui/charts/ReChart.h"

namespace vestige {
namespace {

QString qt(const std::string& text) {
    return QString::fromStdString(text);
}

/// Lines that may break across pages, each painted by itself.
void layoutLines(PageFlow& flow, const QStringList& lines, const QFont& font, const QColor& color,
                 double leading) {
    const QFontMetricsF metrics(font);
    const double height = leading * metrics.height();
    for (const QString& line : lines)
        flow.place(height, [=](QPainter& painter, const QPointF& at) {
            painter.setFont(font);
            painter.setPen(color);
            painter.drawText(QPointF(at.x(), at.y() + metrics.ascent()), line);
        });
}

void layout(PageFlow& flow, const Paragraph& paragraph) {
    const QFont font = flow.style().font(9.5);
    const QStringList lines = wrapText(qt(paragraph.text), font, flow.width());
    flow.keepTogether(std::min<double>(lines.size(), 3) * QFontMetricsF(font).height() * 1.22);
    layoutLines(flow, lines, font, flow.style().text, 1.22);
    flow.space(dotsFromMm(2.2));
}

void layout(PageFlow& flow, const Facts& facts) {
    const PageStyle style = flow.style();
    const QFont nameFont = style.font(9);
    const QFont valueFont = style.font(9);
    const QFontMetricsF metrics(valueFont);
    const double nameWidth = dotsFromMm(48);
    const double line = 1.18 * metrics.height();
    for (const auto& [name, value] : facts.rows) {
        const QStringList names = wrapText(qt(name), nameFont, nameWidth - dotsFromMm(3));
        const QStringList values = wrapText(qt(value), valueFont, flow.width() - nameWidth);
        const double rows = std::max(names.size(), values.size());
        flow.place(rows * line + dotsFromMm(0.9), [=](QPainter& painter, const QPointF& at) {
            double baseline = at.y() + metrics.ascent();
            painter.setFont(nameFont);
            painter.setPen(style.muted);
            for (int i = 0; i < names.size(); ++i)
                painter.drawText(QPointF(at.x(), baseline + i * line), names[i]);
            painter.setFont(valueFont);
            painter.setPen(style.text);
            for (int i = 0; i < values.size(); ++i)
                painter.drawText(QPointF(at.x() + nameWidth, baseline + i * line), values[i]);
        });
    }
    flow.space(dotsFromMm(2.5));
}

/// A picture as it is painted: without alpha channel, which PDF/A-1b forbids.
struct PlacedPicture {
    QImage image;
    QStringList caption;
    double width;
    double height;
    bool toScale = false;
};

/// The finest that print shows of a picture; beyond it pixels only make the file large.
constexpr double kPicturePerInch = 220;

PlacedPicture load(const PageFlow& flow, const Picture& picture, double width, const QFont& captionFont) {
    QImage read(QString::fromStdString(picture.png.string()));
    if (read.isNull())
        throw ErrorException{
            {ErrorCode::output, "the picture cannot be read", picture.png.string(), "PNG expected"}};
    QImage opaque(read.size(), QImage::Format_RGB32);
    opaque.fill(Qt::white);
    {
        QPainter onto(&opaque);
        onto.drawImage(0, 0, read);
    }
    double height = width * opaque.height() / opaque.width();
    const double limit = 0.46 * flow.pageHeight();
    double shown = width;
    if (picture.toScale && read.dotsPerMeterX() > 0) {
        const double own = dotsFromMm(1000.0 * read.width() / read.dotsPerMeterX());
        // One that does not fit would be a lie at any other size; its caption gives the scale.
        if (own <= 1.001 * width) {
            shown = own;
            height = own * opaque.height() / opaque.width();
            return {opaque.convertToFormat(QImage::Format_RGB888),
                    wrapText(qt(picture.caption), captionFont, width), shown, height, true};
        }
    }
    if (height > limit) {
        shown *= limit / height;
        height = limit;
    }
    const int finest = static_cast<int>(shown / kDotsPerInch * kPicturePerInch);
    if (opaque.width() > finest) opaque = opaque.scaledToWidth(finest, Qt::SmoothTransformation);
    return {opaque.convertToFormat(QImage::Format_RGB888), wrapText(qt(picture.caption), captionFont, width),
            shown, height};
}

/// Pictures that would leave much of a page empty because they only just do not fit become smaller, at most
/// to two thirds.
void fitToPage(const PageFlow& flow, std::vector<PlacedPicture>& pictures, double captionHeight) {
    double tallest = 0;
    for (const PlacedPicture& picture : pictures) tallest = std::max(tallest, picture.height);
    const double factor = (flow.remaining() - captionHeight) / tallest;
    if (factor >= 1 || factor < 0.67) return;
    if (std::any_of(pictures.begin(), pictures.end(), [](const PlacedPicture& one) { return one.toScale; }))
        return;
    for (PlacedPicture& picture : pictures) {
        picture.width *= factor;
        picture.height *= factor;
    }
}

void layoutPictures(PageFlow& flow, const std::vector<const Picture*>& row) {
    const PageStyle style = flow.style();
    const QFont captionFont = style.font(8);
    const double gap = dotsFromMm(4);
    const double line = 1.18 * QFontMetricsF(captionFont).height();
    const bool whole = row.size() == 1 && row.front()->width > 0.75;
    const double width = whole ? flow.width() : (flow.width() - gap) / 2;
    auto pictures = std::make_shared<std::vector<PlacedPicture>>();
    double captionHeight = 0;
    for (const Picture* picture : row) {
        pictures->push_back(load(flow, *picture, width, captionFont));
        captionHeight = std::max(captionHeight, pictures->back().caption.size() * line);
    }
    captionHeight += dotsFromMm(1.6);
    fitToPage(flow, *pictures, captionHeight);
    double height = 0;
    for (const PlacedPicture& picture : *pictures) height = std::max(height, picture.height);
    flow.place(height + captionHeight, [=](QPainter& painter, const QPointF& at) {
        double x = at.x();
        for (const PlacedPicture& picture : *pictures) {
            painter.drawImage(QRectF(x, at.y(), picture.width, picture.height), picture.image);
            painter.setPen(style.muted);
            painter.setFont(captionFont);
            for (int i = 0; i < picture.caption.size(); ++i)
                painter.drawText(QPointF(x, at.y() + picture.height + dotsFromMm(1) + (i + 0.8) * line),
                                 picture.caption[i]);
            x += width + gap;
        }
    });
    flow.space(dotsFromMm(3.5));
}

/// A chart of this height with its caption below; `paint` draws it into a rectangle.
void layoutChart(PageFlow& flow, const std::string& words, double height,
                 std::function<void(QPainter&, const QRectF&, const ChartStyle&)> paint) {
    const PageStyle style = flow.style();
    const QFont captionFont = style.font(8);
    const QStringList caption = wrapText(qt(words), captionFont, flow.width());
    const double line = 1.18 * QFontMetricsF(captionFont).height();
    const double width = flow.width();
    flow.place(height + caption.size() * line + dotsFromMm(1.6), [=](QPainter& painter, const QPointF& at) {
        paint(painter, QRectF(at, QSizeF(width, height)),
              paperChartStyle(style.font(7.5), dotsFromPoints(0.75)));
        painter.setClipping(false);
        painter.setFont(captionFont);
        painter.setPen(style.muted);
        for (int i = 0; i < caption.size(); ++i)
            painter.drawText(QPointF(at.x(), at.y() + height + dotsFromMm(1) + (i + 0.8) * line), caption[i]);
    });
    flow.space(dotsFromMm(3.5));
}

void layout(PageFlow& flow, const BarChart& chart) {
    layoutChart(flow, chart.caption, dotsFromMm(82),
                [=](QPainter& painter, const QRectF& area, const ChartStyle& style) {
                    paintReChart(painter, area, chart, style);
                });
}

void layout(PageFlow& flow, const LineChart& chart) {
    layoutChart(flow, chart.caption, dotsFromMm(66),
                [=](QPainter& painter, const QRectF& area, const ChartStyle& style) {
                    paintLineChart(painter, area, chart, style);
                });
}

void layout(PageFlow& flow, const Diagram& diagram) {
    layoutChart(flow, diagram.caption, dotsFromMm(58),
                [=](QPainter& painter, const QRectF& area, const ChartStyle& style) {
                    paintDiagram(painter, area, diagram, style);
                });
}

void layout(PageFlow& flow, const Table& table) {
    layoutTable(flow, table);
}

}  // namespace

void layoutTitle(PageFlow& flow, const Report& report) {
    const PageStyle style = flow.style();
    layoutLines(flow, wrapText(qt(report.title), style.font(21, QFont::DemiBold), flow.width()),
                style.font(21, QFont::DemiBold), style.accent, 1.1);
    flow.space(dotsFromMm(1));
    if (!report.subtitle.empty())
        layoutLines(flow, wrapText(qt(report.subtitle), style.font(11), flow.width()), style.font(11),
                    style.muted, 1.15);
    const double width = flow.width();
    flow.space(dotsFromMm(3));
    flow.place(dotsFromMm(3.5), [=](QPainter& painter, const QPointF& at) {
        painter.fillRect(QRectF(at, QSizeF(width, dotsFromMm(0.6))), style.accent);
    });
    Facts about;
    if (!report.caseName.empty()) about.rows.emplace_back(say("Case"), report.caseName);
    if (!report.operatorName.empty()) about.rows.emplace_back(say("Operator"), report.operatorName);
    about.rows.emplace_back(say("Report made"), report.date);
    about.rows.emplace_back(say("Made with"), report.software);
    layout(flow, about);
}

void layoutSection(PageFlow& flow, const Section& section, int number) {
    const PageStyle style = flow.style();
    flow.space(dotsFromMm(4));
    const QFont font = style.font(13.5, QFont::DemiBold);
    const QFontMetricsF metrics(font);
    // A heading never stands alone at the foot of a page.
    flow.keepTogether(metrics.height() + dotsFromMm(26));
    const QString title = QString::number(number) + QStringLiteral("   ") + qt(section.title);
    layoutLines(flow, wrapText(title, font, flow.width()), font, style.accent, 1.15);
    flow.space(dotsFromMm(1.6));
    for (std::size_t i = 0; i < section.blocks.size(); ++i) {
        if (const auto* picture = std::get_if<Picture>(&section.blocks[i])) {
            std::vector<const Picture*> row{picture};
            const auto* next =
                i + 1 < section.blocks.size() ? std::get_if<Picture>(&section.blocks[i + 1]) : nullptr;
            if (picture->width <= 0.5 && next && next->width <= 0.5) {
                row.push_back(next);
                ++i;
            }
            layoutPictures(flow, row);
        } else {
            std::visit(
                [&](const auto& block) {
                    if constexpr (!std::is_same_v<std::decay_t<decltype(block)>, Picture>)
                        layout(flow, block);
                },
                section.blocks[i]);
        }
    }
}

}  // namespace vestige
