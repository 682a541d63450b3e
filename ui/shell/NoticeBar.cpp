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
    : QWidget(parent), text_(new QLabel), open_(new QToolButton) {
    setObjectName("notice");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(text_, 1);
    open_->setText(tr("Show"));
    row->addWidget(open_);
    auto* close = new QToolButton;
    close->setText(QString::fromUtf8("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message"));
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    connect(open_, &QToolButton::clicked, this,
            [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(path_)); });
    hide_.setSingleShot(true);
    connect(&hide_, &QTimer::timeout, this, &QWidget::hide);
    connect(&notices, &Notices::informed, this, [this](const QString& s) { show(s, false, {}); });
    connect(&notices, &Notices::informedOf, this,
            [this](const QString& s, const QString& path) { show(s, false, path); });
    connect(&notices, &Notices::warned, this, [this](const QString& s) { show(s, true, {}); });
    hide();
}

QString NoticeBar::text() const {
    return isHidden() ? QString() : text_->text();
}

void NoticeBar::show(const QString& sentence, bool warning, const QString& path) {
    path_ = path;
    text_->setText(sentence);
    open_->setVisible(!path.isEmpty());
    setProperty("warning", warning);
    style()->unpolish(this);
    style()->polish(this);
    setVisible(true);
    if (warning)
        hide_.stop();
    else
        hide_.start(path.isEmpty() ? 8000 : 30000);
}

}  // namespace vestige
