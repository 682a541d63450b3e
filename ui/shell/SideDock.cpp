#include "ui/shell/SideDock.h"

#include <QKeyEvent>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include "ui/shell/GuidePage.h"
#include "ui/shell/ShortcutsPage.h"

namespace vestige {

SideDock::SideDock(const ActionCatalog& actions, Shortcuts& shortcuts, QWidget* parent)
    : QDockWidget(tr("Help"), parent), tabs_(new QTabWidget) {
    setObjectName("side-dock");
    setAccessibleName(tr("Help"));
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    // The tabs say what it is; the title bar would say it again.
    setTitleBarWidget(new QWidget);
    tabs_->setObjectName("help-tabs");
    tabs_->setDocumentMode(true);
    tabs_->setAccessibleName(tr("Help"));
    tabs_->tabBar()->setAccessibleName(tr("Help"));
    tabs_->addTab(new GuidePage, tr("Guide"));
    tabs_->addTab(new ShortcutsPage(actions, shortcuts), tr("Shortcuts"));
    auto* close = new QToolButton;
    close->setText(QString::fromUtf8("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close (Esc)"));
    close->setAccessibleName(tr("Close help"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    tabs_->setCornerWidget(close);
    setMinimumWidth(350);
    setWidget(tabs_);
}

void SideDock::showGuide() {
    open(0);
}

void SideDock::showShortcuts() {
    open(1);
}

void SideDock::open(int tab) {
    tabs_->setCurrentIndex(tab);
    show();
    raise();
    tabs_->currentWidget()->setFocus();
}

void SideDock::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QDockWidget::keyPressEvent(event);
    hide();
}

}  // namespace vestige
