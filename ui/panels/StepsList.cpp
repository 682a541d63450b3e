#include "ui/panels/StepsList.h"

#include <QLabel>
#include <QPushButton>
#include <QTextLayout>
#include <QVBoxLayout>
#include <algorithm>

namespace vestige {
namespace {

/// In lines of at most that width: between words, and within what has no blanks (Chinese, names of files).
QString broken(const QString& text, const QFont& font, int width) {
    QTextLayout layout(text, font);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(std::max(40, width));
        lines << text.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines.join('\n');
}

}  // namespace

StepsList::StepsList(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(2);
}

void StepsList::setSteps(const std::array<StepFacts, kWaySteps>& steps) {
    QStringList lines;
    std::vector<WayStep> places;
    for (const StepFacts& facts : steps)
        for (const QString& missing : facts.missing) {
            lines << titleOf(facts.step) + ": " + missing;
            places.push_back(facts.step);
        }
    if (lines == shown_ && column_->count() > 0) return;
    shown_ = lines;
    while (QLayoutItem* item = column_->takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    if (lines.isEmpty()) {
        auto* nothing = new QLabel(tr("Nothing is missing."));
        nothing->setProperty("role", "muted");
        column_->addWidget(nothing);
        return;
    }
    for (int i = 0; i < lines.size(); ++i) {
        auto* link = new QPushButton;
        link->setAccessibleName(lines[i]);
        // As wide as the panel is, not as its text.
        link->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        link->setProperty("role", "link");
        link->setToolTip(tr("Go to %1").arg(titleOf(places[static_cast<std::size_t>(i)])));
        link->setCursor(Qt::PointingHandCursor);
        connect(link, &QPushButton::clicked, this,
                [this, step = places[static_cast<std::size_t>(i)]] { emit chosen(step); });
        column_->addWidget(link);
    }
    wrap();
}

void StepsList::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    wrap();
}

/// Buttons break no lines by themselves.
void StepsList::wrap() {
    for (int i = 0; i < column_->count(); ++i)
        if (auto* link = qobject_cast<QPushButton*>(column_->itemAt(i)->widget()))
            link->setText(broken(link->accessibleName(), link->font(), width() - 4));
}

}  // namespace vestige
