#include "ui/panels/HistoryPanel.h"

#include <QAction>
#include <QListWidget>
#include <QToolButton>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/History.h"
#include "ui/panels/PanelColors.h"

namespace vestige {

HistoryPanel::HistoryPanel(History& history, const ActionCatalog& actions, QWidget* parent)
    : PanelSection(tr("History"), parent), history_(history), list_(new QListWidget) {
    setObjectName("history-panel");
    auto* close = new QToolButton;
    close->setText(QString::fromUtf8("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close the history"));
    close->setAccessibleName(close->toolTip());
    connect(close, &QToolButton::clicked, &actions["edit.history"], &QAction::trigger);
    addToHeading(close);
    list_->setObjectName("history");
    list_->setAccessibleName(tr("History"));
    list_->setToolTip(tr("A click takes the case to that step"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setUniformItemSizes(true);
    setContent(list_, 1);
    const auto go = [this](const QListWidgetItem* item) {
        // The list is filled anew by what this does, which must not happen while it reports the click.
        const auto done = static_cast<std::size_t>(list_->row(item));
        QMetaObject::invokeMethod(
            this, [this, done] { history_.goTo(done); }, Qt::QueuedConnection);
    };
    connect(list_, &QListWidget::itemClicked, this, go);
    connect(list_, &QListWidget::itemActivated, this, go);
    connect(&history_, &History::changed, this, [this] { fill(); });
    onPaletteChange(*this, [this] { fill(); });
    fill();
}

void HistoryPanel::fill() {
    const auto& steps = history_.steps();
    list_->clear();
    for (std::size_t i = 0; i <= steps.size(); ++i) {
        QString text = i == 0 ? tr("As it was opened") : steps[i - 1].text;
        if (!text.isEmpty()) text[0] = text[0].toUpper();
        auto* item = new QListWidgetItem(text);
        const bool present = i == history_.done();
        QFont font = list_->font();
        font.setBold(present);
        item->setFont(font);
        if (i > history_.done()) item->setForeground(quietColor(palette()));
        const QString place = present               ? tr("the present step")
                              : i < history_.done() ? tr("done")
                                                    : tr("undone");
        item->setToolTip(text + "\n" + place);
        item->setData(Qt::AccessibleTextRole, text + ", " + place);
        list_->addItem(item);
    }
    list_->setCurrentRow(static_cast<int>(history_.done()));
    list_->scrollToItem(list_->currentItem());
}

}  // namespace vestige
