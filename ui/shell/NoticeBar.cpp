#include "ui/shell/NoticeBar.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <QUrl>

#include "ui/document/Notices.h"

namespace vestige {

NoticeBar::NoticeBar(Notices& notices, QWidget* parent)
    : QWidget(parent), text_(new QLabel), button_(new QToolButton) {
    setObjectName("notice");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(text_, 1);
    button_->setObjectName("notice-button");
    row->addWidget(button_);
    auto* close = new QToolButton;
    close->setText(QString::fromUtf8("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message"));
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(button_, &QToolButton::clicked, this, [this] {
        const Action action = action_;  // it may bring the next notice
        hide();
        if (action) action();
    });
    hide_.setSingleShot(true);
    connect(&hide_, &QTimer::timeout, this, &QWidget::hide);
    connect(&notices, &Notices::informed, this, [this](const QString& s) { show(s, false); });
    connect(&notices, &Notices::informedOf, this, [this](const QString& s, const QString& path) {
        show(s, false, tr("Show"), [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); });
    });
    connect(&notices, &Notices::warned, this, [this](const QString& s) { show(s, true); });
    connect(&notices, &Notices::offered, this,
            [this](const QString& s, const QString& label, const Action& action) {
                show(s, true, label, action);
            });
    hide();
}

QString NoticeBar::text() const {
    return isHidden() ? QString() : text_->text();
}

void NoticeBar::show(const QString& sentence, bool warning, const QString& label, const Action& action) {
    action_ = action;
    text_->setText(sentence);
    button_->setText(label);
    button_->setVisible(!label.isEmpty());
    setProperty("warning", warning);
    style()->unpolish(this);
    style()->polish(this);
    setVisible(true);
    if (warning)
        hide_.stop();
    else
        hide_.start(label.isEmpty() ? 8000 : 30000);
}

}  // namespace vestige
