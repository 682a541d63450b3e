#include "ui/panels/FiguresTree.h"

#include <QHeaderView>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/report/BudgetBlocks.h"
#include "core/report/QuantityText.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

enum Column { figure, value, uncertainty, share, columns };

QString degreesText(double degrees) {
    return std::isfinite(degrees) ? toQt(fixedText(degrees, 1)) : QString(QChar(0x221E));
}

QString tipOf(const QuantityStatistic& quantity) {
    QStringList lines{said(quantity.label) + ": " + said(quantitySentence(quantity))};
    if (quantity.low && quantity.high)
        lines << QObject::tr("95 % interval: %1 %2")
                     .arg(toQt(quantityIntervalText(quantity)), toQt(readableSymbol(quantity.unit)));
    QStringList repeats;
    for (const double each : quantity.repeats) repeats << toQt(fixedText(each, 4));
    lines << QObject::tr("Repeats: %1").arg(repeats.join(", "));
    if (quantity.expandedUncertainty)
        lines << QObject::tr("u = %1, degrees of freedom %2, k = %3")
                     .arg(toQt(inputText(quantity.budget.standard, std::string(symbol(quantity.unit)))),
                          degreesText(quantity.budget.degreesOfFreedom),
                          toQt(fixedText(quantity.budget.coverageFactor, 2)));
    else
        lines << QObject::tr("One repeat only: its scatter is not known, so there is no U.");
    return lines.join("\n");
}

QString tipOf(const Contribution& line, QuantityUnit unit) {
    return QObject::tr(
               "%1: standard uncertainty %2 (%3, degrees of freedom %4), which makes %5 of the figure")
        .arg(said(line.source), toQt(inputText(line.value, line.unit)), said(name(line.distribution)),
             degreesText(line.degreesOfFreedom), toQt(inputText(line.part(), std::string(symbol(unit)))));
}

}  // namespace

FiguresTree::FiguresTree(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("figures");
    setAccessibleName(tr("Figures and uncertainty budgets"));
    setColumnCount(columns);
    setHeaderLabels({tr("Figure"), tr("Value"), tr("U 95 %"), tr("Share")});
    setFrameShape(QFrame::NoFrame);
    setUniformRowHeights(true);
    setIndentation(14);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(30);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(figure, QHeaderView::Stretch);
    for (const int column : {value, uncertainty, share})
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    connect(this, &QTreeWidget::itemExpanded, this, [this] { rememberFolds(); });
    connect(this, &QTreeWidget::itemCollapsed, this, [this] { rememberFolds(); });
}

void FiguresTree::rememberFolds() {
    open_.clear();
    for (int i = 0; i < topLevelItemCount(); ++i)
        if (topLevelItem(i)->isExpanded()) open_.insert(topLevelItem(i)->data(0, Qt::UserRole).toString());
}

void FiguresTree::showFigures(const MeasuredKind* kind) {
    const QSignalBlocker quiet(this);
    if (!kind || kind->object != object_) open_.clear();
    object_ = kind ? kind->object : std::string();
    clear();
    if (!kind) return;
    for (const QuantityStatistic& each : kind->quantities) {
        auto* item = new QTreeWidgetItem(this);
        const QString unit = toQt(readableSymbol(each.unit));
        item->setText(figure, said(each.label));
        item->setText(value,
                      toQt(quantityValueText(each)) + (unit == QString::fromUtf8("°") ? "" : " ") + unit);
        item->setText(uncertainty, toQt(quantityUncertaintyText(each)));
        item->setData(0, Qt::UserRole, toQt(each.key));
        for (const Contribution& line : each.budget.contributions) {
            auto* part = new QTreeWidgetItem(item);
            part->setText(figure, said(line.source));
            part->setText(value, toQt(inputText(line.value, line.unit)));
            part->setText(uncertainty, toQt(inputText(line.part(), std::string(symbol(each.unit)))));
            part->setText(share, toQt(fixedText(100 * line.share, 0)) + " %");
            for (int column = 0; column < columns; ++column) part->setToolTip(column, tipOf(line, each.unit));
        }
        for (int row = -1; row < item->childCount(); ++row) {
            QTreeWidgetItem* line = row < 0 ? item : item->child(row);
            for (const int column : {value, uncertainty, share})
                line->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        }
        for (int column = 0; column < columns; ++column) item->setToolTip(column, tipOf(each));
        item->setExpanded(open_.count(toQt(each.key)) > 0);
    }
}

}  // namespace vestige
