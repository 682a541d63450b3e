#include "ui/panels/PanelSection.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QPainter>
#include <QTreeWidget>

namespace vestige {

PanelSection::PanelSection(const QString& title, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    heading_ = new QHBoxLayout;
    heading_->setContentsMargins(12, 6, 12, 4);
    auto* label = new QLabel(title);
    label->setProperty("role", "heading");
    heading_->addWidget(label, 1);
    column->addLayout(heading_);
}

void PanelSection::addToHeading(QWidget* widget) {
    heading_->addWidget(widget);
}

void PanelSection::setContent(QWidget* content, int stretch) {
    static_cast<QVBoxLayout*>(layout())->addWidget(content, stretch);
}

PanelSection* addSection(QVBoxLayout& column, const QString& title, QWidget* content) {
    auto* section = new PanelSection(title);
    content->setContentsMargins(12, 0, 12, 8);
    section->setContent(content);
    column.addWidget(section);
    return section;
}

CompactList::CompactList(const QString& emptyText, QWidget* parent)
    : QWidget(parent), tree_(new QTreeWidget), empty_(new QLabel(emptyText)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    tree_->setColumnCount(2);
    tree_->setHeaderHidden(true);
    tree_->setRootIsDecorated(false);
    tree_->setIndentation(0);
    tree_->setUniformRowHeights(true);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tree_->setTextElideMode(Qt::ElideRight);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setMinimumSectionSize(20);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    empty_->setProperty("role", "muted");
    empty_->setWordWrap(true);
    empty_->setContentsMargins(12, 2, 12, 6);
    column->addWidget(tree_);
    column->addWidget(empty_);
    fit();
}

void CompactList::fit() {
    const int rows = tree_->topLevelItemCount();
    const int height = rows == 0 ? 0 : tree_->sizeHintForRow(0) * rows + 2;
    tree_->setVisible(rows > 0);
    tree_->setFixedHeight(height);
    empty_->setVisible(rows == 0);
}

QIcon swatch(const QColor& color) {
    QPixmap picture(32, 32);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(6, 6, 20, 20), 6, 6);
    return QIcon(picture);
}

}  // namespace vestige
