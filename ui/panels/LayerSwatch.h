#pragma once

#include <QStyledItemDelegate>

namespace vestige {

/// Draws a checkable row's box as a square of the layer's colour: filled while the layer is shown, an outline
/// while it is hidden. It switches as a box does, by a click or with Space.
class LayerSwatch : public QStyledItemDelegate {
    Q_OBJECT

  public:
    /// A row's data: its QColor.
    static constexpr int kColorRole = Qt::UserRole + 1;

    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

}  // namespace vestige
