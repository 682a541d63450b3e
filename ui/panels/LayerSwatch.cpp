#include "ui/panels/LayerSwatch.h"

#include <QApplication>
#include <QPainter>

namespace vestige {

void LayerSwatch::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
    const QVariant state = index.data(Qt::CheckStateRole);
    if (!state.isValid()) return;
    QStyleOptionViewItem row = option;
    initStyleOption(&row, index);
    const QStyle* style = row.widget ? row.widget->style() : QApplication::style();
    const QRectF box = style->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &row, row.widget);
    const auto color = index.data(kColorRole).value<QColor>();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF square(box.center().x() - 5, box.center().y() - 5, 10, 10);
    const bool shown = state.toInt() == Qt::Checked;
    painter->setPen(QPen(color, 1.4));
    painter->setBrush(shown ? QBrush(color) : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(square, 3, 3);
    painter->restore();
}

}  // namespace vestige
