#include "ui/shell/SideDock.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include "ui/shell/GuidePage.h"
#include "ui/shell/ShortcutsPage.h"

namespace vestige {

SideDock::SideDock(const ActionCatalog& actions, Shortcuts& shortcuts, QWidget* parent)
    : QDockWidget(tr("Help"), parent),
      tabs_(new QTabWidget),
      guide_(new GuidePage("guide")),
      tutorial_(new GuidePage("tutorial")) {
    setObjectName("side-dock");
    setAccessibleName(tr("Help"));
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    tabs_->setObjectName("help-tabs");
    tabs_->setDocumentMode(true);
    tabs_->setAccessibleName(tr("Help"));
    tabs_->tabBar()->setAccessibleName(tr("Help"));
    tabs_->addTab(guide_, tr("Guide"));
    tabs_->addTab(tutorial_, tr("Tutorial"));
    for (GuidePage* from : {guide_, tutorial_})
        connect(from, &GuidePage::pageWanted, this, [this](const QString& page, const QString& anchor) {
            GuidePage* wanted = page == "tutorial" ? tutorial_ : guide_;
            tabs_->setCurrentWidget(wanted);
            wanted->goToAnchor(anchor);
        });
    tabs_->addTab(new ShortcutsPage(actions, shortcuts), tr("Shortcuts"));
    auto* close = new QToolButton;
    close->setText(QString::fromUtf8("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close (Esc)"));
    close->setAccessibleName(tr("Close help"));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(12, 6, 6, 2);
    auto* title = new QLabel(tr("Help"));
    title->setProperty("role", "heading");
    row->addWidget(title, 1);
    row->addWidget(close);
    setTitleBarWidget(bar);
    setMinimumWidth(340);
    setWidget(tabs_);
}

void SideDock::showGuide() {
    open(0);
}

void SideDock::showTutorial() {
    open(1);
}

void SideDock::showShortcuts() {
    open(2);
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
