#include "ui/panels/FiguresRow.h"

#include <QHBoxLayout>
#include <QLabel>

namespace vestige {

FiguresRow::FiguresRow(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
    row_->setContentsMargins(12, 6, 12, 2);
    row_->setSpacing(20);
}

void FiguresRow::setFigures(const std::vector<Figure>& figures, const QString& role) {
    cells_.clear();
    while (QLayoutItem* item = row_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    QStringList said;
    for (const Figure& figure : figures) {
        auto* cell = new QWidget;
        auto* column = new QVBoxLayout(cell);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(1);
        auto* value = new QLabel(figure.value);
        value->setProperty("role", role);
        if (figure.color.isValid()) value->setStyleSheet("color: " + figure.color.name());
        auto* caption = new QLabel(figure.caption);
        caption->setProperty("role", "caption");
        column->addWidget(value);
        column->addWidget(caption);
        row_->addWidget(cell);
        cells_.push_back(cell);
        said << figure.value + " " + figure.caption;
    }
    row_->addStretch(1);
    setAccessibleDescription(said.join("; "));
    showWhatFits();
}

void FiguresRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showWhatFits();
}

void FiguresRow::showWhatFits() {
    const QMargins margins = row_->contentsMargins();
    int used = margins.left() + margins.right() - row_->spacing();
    for (QWidget* cell : cells_) {
        used += row_->spacing() + cell->sizeHint().width();
        cell->setVisible(cell == cells_.front() || used <= width());
    }
}

}  // namespace vestige
