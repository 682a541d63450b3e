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
    : QWidget(parent), text_(new QLabel), open_(new QToolButton), offers_(new QWidget) {
    setObjectName("notice");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(text_, 1);
    open_->setText(tr("Show"));
    row->addWidget(open_);
    new QHBoxLayout(offers_);
    offers_->layout()->setContentsMargins(0, 0, 0, 0);
    row->addWidget(offers_);
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
    connect(&notices, &Notices::offered, this, &NoticeBar::offer);
    hide();
}

QString NoticeBar::text() const {
    return isHidden() ? QString() : text_->text();
}

void NoticeBar::show(const QString& sentence, bool warning, const QString& path) {
    path_ = path;
    qDeleteAll(offers_->findChildren<QToolButton*>());
    offers_->hide();
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

void NoticeBar::offer(const QString& sentence, const std::vector<Notices::Offer>& offers) {
    show(sentence, true, {});
    for (std::size_t i = 0; i < offers.size(); ++i) {
        auto* button = new QToolButton;
        button->setObjectName(QString("offer-%1").arg(i + 1));
        button->setText(offers[i].text);
        // Taking the offer may show another one in the place of this, buttons and all.
        connect(button, &QToolButton::clicked, this, [this, take = offers[i].take] {
            hide();
            QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
        });
        offers_->layout()->addWidget(button);
    }
    offers_->show();
}

}  // namespace vestige
