#include "ui/shell/NoticeBar.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <QUrl>
#include <utility>

namespace vestige {

NoticeBar::NoticeBar(Notices& notices, QWidget* parent)
    : QWidget(parent), text_(new QLabel), offers_(new QHBoxLayout) {
    setObjectName("notice");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(text_, 1);
    row->addLayout(offers_);
    auto* close = new QToolButton;
    close->setText(QString::fromUtf8("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this message"));
    close->setAccessibleName(close->toolTip());
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, [this] {
        open_.clear();
        hide();
    });
    hide_.setSingleShot(true);
    connect(&hide_, &QTimer::timeout, this, &QWidget::hide);
    connect(&notices, &Notices::informed, this, [this](const QString& s) { tell(s, false); });
    connect(&notices, &Notices::informedOf, this, [this](const QString& s, const QString& path) {
        tell(s, false, {{tr("Show"), [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); }}});
    });
    connect(&notices, &Notices::warned, this, [this](const QString& s) { tell(s, true); });
    connect(&notices, &Notices::offered, this,
            [this](const QString& s, const std::vector<Notices::Offer>& offers) { offer(s, offers); });
    connect(&notices, &Notices::withdrawn, this, [this] {
        if (!open_.empty()) hide();
        open_.clear();
    });
    hide();
}

QString NoticeBar::text() const {
    return isHidden() ? QString() : text_->text();
}

void NoticeBar::tell(const QString& sentence, bool warning, const std::vector<Notices::Offer>& offers) {
    if (open_.empty()) return show(sentence, warning, offers);
    show(sentence + '\n' + offered_, true, open_);
}

void NoticeBar::offer(const QString& sentence, std::vector<Notices::Offer> offers) {
    offered_ = sentence;
    open_ = std::move(offers);
    show(sentence, true, open_);
}

void NoticeBar::taken(const Notices::Offer& offer) {
    std::erase_if(open_, [&](const Notices::Offer& other) { return other.group == offer.group; });
    if (open_.empty())
        hide();
    else
        show(offered_, true, open_);
    offer.take();
}

void NoticeBar::show(const QString& sentence, bool warning, const std::vector<Notices::Offer>& offers) {
    // One of them may be what was pressed just now.
    for (QToolButton* button : std::exchange(buttons_, {})) {
        button->setObjectName({});
        button->hide();
        button->deleteLater();
    }
    for (const Notices::Offer& one : offers) {
        auto* button = new QToolButton;
        button->setObjectName(buttons_.empty() ? QString("notice-button")
                                               : QString("notice-button-%1").arg(buttons_.size() + 1));
        button->setText(one.text);
        connect(button, &QToolButton::clicked, this, [this, one] { taken(one); });
        offers_->addWidget(button);
        buttons_.push_back(button);
    }
    text_->setText(sentence);
    setProperty("warning", warning);
    style()->unpolish(this);
    style()->polish(this);
    setVisible(true);
    if (warning)
        hide_.stop();
    else
        hide_.start(offers.empty() ? 8000 : 30000);
}

}  // namespace vestige
