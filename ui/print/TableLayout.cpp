#include <QFontMetricsF>
#include <QPainter>
#include <QTextBoundaryFinder>
#include <algorithm>
#include <numeric>

#include "core/base/Translation.h"
#include "ui/print/BlockLayout.h"

namespace vestige {
namespace {

constexpr int kMostLines = 40;  // of one row; a longer cell goes on in the next row

struct Cell {
    QStringList lines;
    bool right = false;
};
using Row = std::vector<Cell>;

struct TableShape {
    PageStyle style;
    QFont font;
    QFont headFont;
    std::vector<double> widths;
    std::vector<bool> right;
    double pad = dotsFromMm(1.4);
    double line = 0;
    double width = 0;
};

/// Chinese is written without spaces and breaks between most of its characters.
bool isIdeographic(const QString& word) {
    return std::any_of(word.begin(), word.end(),
                       [](const QChar c) { return c.script() == QChar::Script_Han; });
}

double longestWord(const QFontMetricsF& metrics, const QString& text) {
    double widest = 0;
    for (const QString& word : text.split(QLatin1Char(' '))) {
        if (!isIdeographic(word)) {
            widest = std::max(widest, metrics.horizontalAdvance(word));
            continue;
        }
        // A short heading stands on one line all the same.
        const double fourCharacters = 4.2 * metrics.horizontalAdvance(word.left(1));
        widest = std::max(widest, std::min(fourCharacters, metrics.horizontalAdvance(word)));
        QTextBoundaryFinder places(QTextBoundaryFinder::Line, word);
        for (int begin = 0, end = places.toNextBoundary(); end > 0;
             begin = end, end = places.toNextBoundary())
            widest = std::max(widest, metrics.horizontalAdvance(word.mid(begin, end - begin)));
    }
    return widest;
}

/// Widths that sum up to the text's: by wish, else by content, where a column of figures is never broken and
/// the text columns share what is left.
std::vector<double> columnWidths(const Table& table, const TableShape& shape) {
    const std::size_t n = table.columns.size();
    std::vector<double> widths(n, 0);
    if (table.widths.size() == n) {
        const double sum = std::accumulate(table.widths.begin(), table.widths.end(), 0.0);
        for (std::size_t c = 0; c < n; ++c) widths[c] = shape.width * table.widths[c] / sum;
        return widths;
    }
    const QFontMetricsF metrics(shape.font);
    const QFontMetricsF headMetrics(shape.headFont);
    std::vector<double> least(n, 0);
    for (std::size_t c = 0; c < n; ++c) {
        const double head = longestWord(headMetrics, QString::fromStdString(table.columns[c]));
        least[c] = widths[c] = head;
        for (const auto& row : table.rows) {
            const QString text = QString::fromStdString(row[c]);
            const double whole =
                shape.right[c] ? figuresWidth(shape.font, text) : metrics.horizontalAdvance(text);
            widths[c] = std::max(widths[c], whole);
            least[c] = std::max(
                least[c], shape.right[c] ? whole : std::min(longestWord(metrics, text), dotsFromMm(30)));
        }
        widths[c] += 2 * shape.pad;
        least[c] += 2 * shape.pad;
    }
    const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
    const double leastSum = std::accumulate(least.begin(), least.end(), 0.0);
    if (sum <= shape.width) {
        for (std::size_t c = 0; c < n; ++c) widths[c] *= shape.width / sum;
        return widths;
    }
    const double share = leastSum < shape.width ? (shape.width - leastSum) / (sum - leastSum) : 0;
    const double squeeze = leastSum > shape.width ? shape.width / leastSum : 1;
    for (std::size_t c = 0; c < n; ++c) widths[c] = squeeze * (least[c] + share * (widths[c] - least[c]));
    return widths;
}

/// A row's cells in lines; more than one row where a cell is very long.
std::vector<Row> wrapRow(const std::vector<std::string>& texts, const TableShape& shape, const QFont& font) {
    std::vector<QStringList> cells;
    int longest = 1;
    for (std::size_t c = 0; c < texts.size(); ++c) {
        cells.push_back(wrapText(QString::fromStdString(texts[c]), font, shape.widths[c] - 1.9 * shape.pad));
        longest = std::max(longest, static_cast<int>(cells.back().size()));
    }
    std::vector<Row> rows;
    for (int from = 0; from < longest; from += kMostLines) {
        Row row;
        for (std::size_t c = 0; c < cells.size(); ++c)
            row.push_back({cells[c].mid(from, kMostLines), shape.right[c]});
        rows.push_back(std::move(row));
    }
    return rows;
}

double rowHeight(const Row& row, const TableShape& shape) {
    int lines = 1;
    for (const Cell& cell : row) lines = std::max(lines, static_cast<int>(cell.lines.size()));
    return lines * shape.line + 1.5 * shape.pad;
}

void paintRow(QPainter& painter, const QPointF& at, const Row& row, const TableShape& shape,
              const QFont& font) {
    const QFontMetricsF metrics(font);
    double x = at.x();
    painter.setFont(font);
    painter.setPen(shape.style.text);
    for (std::size_t c = 0; c < row.size(); ++c) {
        double baseline = at.y() + 0.75 * shape.pad + metrics.ascent();
        for (const QString& line : row[c].lines) {
            if (row[c].right)
                drawFigures(painter, font, x + shape.widths[c] - shape.pad, baseline, line, true);
            else
                painter.drawText(QPointF(x + shape.pad, baseline), line);
            baseline += shape.line;
        }
        x += shape.widths[c];
    }
}

void placeRule(PageFlow& flow, const TableShape& shape, double thickness, const QColor& color) {
    flow.place(thickness, [=](QPainter& painter, const QPointF& at) {
        painter.fillRect(QRectF(at, QSizeF(shape.width, thickness)), color);
    });
}

class TablePlacer {
  public:
    TablePlacer(PageFlow& flow, const Table& table) : flow_(flow), table_(table) {
        shape_.style = flow.style();
        shape_.font = shape_.style.font(8.2);
        shape_.headFont = shape_.style.font(8.2, QFont::DemiBold);
        shape_.width = flow.width();
        shape_.line = 1.14 * QFontMetricsF(shape_.font).height();
        shape_.right = table.numeric;
        shape_.right.resize(table.columns.size(), false);
        shape_.widths = columnWidths(table, shape_);
        head_ = wrapRow(table.columns, shape_, shape_.headFont).front();
    }

    void place() {
        keepShortOnesWhole();
        bool first = true;
        for (std::size_t r = 0; r < table_.rows.size(); ++r) {
            const bool set =
                std::find(table_.emphasised.begin(), table_.emphasised.end(), r) != table_.emphasised.end();
            for (Row& row : wrapRow(table_.rows[r], shape_, shape_.font)) {
                const double height = rowHeight(row, shape_);
                if (first || height + dotsFromMm(0.3) > flow_.remaining()) {
                    if (!first) flow_.newPage();
                    placeHead(first, height);
                    first = false;
                }
                placeRow(std::move(row), height, set);
            }
        }
        if (first) placeHead(true, 0);
        flow_.space(dotsFromMm(4));
    }

  private:
    /// A short table goes to the next page as a whole when that leaves little of this page empty.
    void keepShortOnesWhole() {
        if (table_.rows.size() > 8 || flow_.remaining() > flow_.pageHeight() / 4) return;
        double height = rowHeight(head_, shape_) + 2 * shape_.line + dotsFromMm(1);
        for (const auto& texts : table_.rows)
            for (const Row& row : wrapRow(texts, shape_, shape_.font))
                height += rowHeight(row, shape_) + dotsFromMm(0.12);
        flow_.keepTogether(height);
    }

    void placeHead(bool first, double nextRow) {
        const QFont captionFont = shape_.style.font(8.2, QFont::DemiBold);
        const QFontMetricsF metrics(captionFont);
        const QString caption =
            QString::fromStdString(first ? table_.caption : say("%1 (continued)", {table_.caption}));
        const QStringList lines =
            table_.caption.empty() ? QStringList() : wrapText(caption, captionFont, shape_.width);
        const double captionHeight =
            lines.size() * 1.2 * metrics.height() + (lines.empty() ? 0 : dotsFromMm(0.8));
        const double headHeight = rowHeight(head_, shape_);
        flow_.keepTogether(captionHeight + headHeight + nextRow + dotsFromMm(1));
        if (!lines.empty())
            flow_.place(captionHeight, [lines, captionFont, metrics, color = shape_.style.text](
                                           QPainter& painter, const QPointF& at) {
                painter.setFont(captionFont);
                painter.setPen(color);
                for (int i = 0; i < lines.size(); ++i)
                    painter.drawText(QPointF(at.x(), at.y() + metrics.ascent() + i * 1.2 * metrics.height()),
                                     lines[i]);
            });
        placeRule(flow_, shape_, dotsFromMm(0.25), shape_.style.accent);
        flow_.place(headHeight,
                    [shape = shape_, head = head_, headHeight](QPainter& painter, const QPointF& at) {
                        painter.fillRect(QRectF(at, QSizeF(shape.width, headHeight)), shape.style.headRow);
                        paintRow(painter, at, head, shape, shape.headFont);
                    });
    }

    void placeRow(Row row, double height, bool set) {
        flow_.place(height, [shape = shape_, row = std::move(row), height, set](QPainter& painter,
                                                                                const QPointF& at) {
            if (set) painter.fillRect(QRectF(at, QSizeF(shape.width, height)), shape.style.emphasis);
            paintRow(painter, at, row, shape, shape.font);
        });
        placeRule(flow_, shape_, dotsFromMm(0.12), shape_.style.rule);
    }

    PageFlow& flow_;
    const Table& table_;
    TableShape shape_;
    Row head_;
};

}  // namespace

void layoutTable(PageFlow& flow, const Table& table) {
    if (table.columns.empty()) return;
    TablePlacer(flow, table).place();
}

}  // namespace vestige
