#include "ui/panels/TableText.h"

#include <QHeaderView>
#include <QTableView>
#include <QTreeView>
#include <algorithm>
#include <vector>

namespace vestige {
namespace {

bool isHidden(const QAbstractItemView& view, int column) {
    if (const auto* table = qobject_cast<const QTableView*>(&view)) return table->isColumnHidden(column);
    if (const auto* tree = qobject_cast<const QTreeView*>(&view)) return tree->isColumnHidden(column);
    return false;
}

bool showsHeadings(const QAbstractItemView& view) {
    if (const auto* table = qobject_cast<const QTableView*>(&view))
        return !table->horizontalHeader()->isHidden();
    if (const auto* tree = qobject_cast<const QTreeView*>(&view)) return !tree->isHeaderHidden();
    return false;
}

QString cellText(const QVariant& value) {
    QString text = value.toString().simplified();
    text.replace(QChar(0x2212), '-');
    return text == QChar(0x2013) ? QString() : text;
}

std::vector<int> rowsOf(const QAbstractItemView& view, bool all) {
    std::vector<int> rows;
    if (!all && view.selectionModel())
        for (const QModelIndex& index : view.selectionModel()->selectedIndexes()) rows.push_back(index.row());
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (rows.empty())
        for (int row = 0; row < view.model()->rowCount(); ++row) rows.push_back(row);
    return rows;
}

}  // namespace

QString tableText(const QAbstractItemView& view, bool all) {
    const QAbstractItemModel* model = view.model();
    if (!model) return {};
    std::vector<int> columns;
    for (int column = 0; column < model->columnCount(); ++column)
        if (!isHidden(view, column)) columns.push_back(column);
    QStringList lines;
    if (showsHeadings(view)) {
        QStringList cells;
        for (const int column : columns) cells << cellText(model->headerData(column, Qt::Horizontal));
        lines << cells.join('\t');
    }
    for (const int row : rowsOf(view, all)) {
        QStringList cells;
        for (const int column : columns) cells << cellText(model->index(row, column).data());
        lines << cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

}  // namespace vestige
