#include "ui/shell/RecoveryBar.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVariant>
#include <algorithm>

#include "ui/document/Autosave.h"
#include "ui/document/Loader.h"

namespace vestige {

RecoveryBar::RecoveryBar(Autosave& autosave, Loader& loader, std::function<bool()> mayLeave, QWidget* parent)
    : QWidget(parent),
      autosave_(autosave),
      loader_(loader),
      mayLeave_(std::move(mayLeave)),
      text_(new QLabel),
      accept_(new QPushButton),
      discard_(new QPushButton(tr("Discard"))) {
    setObjectName("recovery");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    text_->setObjectName("recovery-text");
    text_->setWordWrap(true);
    row->addWidget(text_, 1);
    accept_->setObjectName("recovery-accept");
    accept_->setProperty("role", "primary");
    discard_->setObjectName("recovery-discard");
    discard_->setProperty("role", "plain");
    row->addWidget(accept_);
    row->addWidget(discard_);
    auto* later = new QToolButton;
    later->setText(QString::fromUtf8("×"));
    later->setAutoRaise(true);
    later->setToolTip(tr("Decide later"));
    later->setAccessibleName(later->toolTip());
    row->addWidget(later);
    connect(accept_, &QPushButton::clicked, this, [this] { accept(); });
    connect(discard_, &QPushButton::clicked, this, [this] { discard(); });
    connect(later, &QToolButton::clicked, this, &QWidget::hide);
    connect(&loader_, &Loader::recovered, this, [this](const QString& sentence) { tellRecovered(sentence); });
    connect(&loader_, &Loader::opened, this, [this] {
        const auto place = autosave_.place().string();
        std::erase_if(offers_, [&](const Abandoned& one) { return one.content.caseFile == place; });
        if (!ofOpenCase_) offerNext();
    });
    connect(&autosave_, &Autosave::changed, this, [this] {
        if (ofOpenCase_ && !autosave_.canDiscardRecovered()) offerNext();
    });
    hide();
}

void RecoveryBar::offerAbandoned() {
    loader_.findAbandoned([this](std::vector<Abandoned> found) {
        offers_ = std::move(found);
        if (!ofOpenCase_) offerNext();
    });
}

void RecoveryBar::offerNext() {
    ofOpenCase_ = false;
    setVisible(!offers_.empty());
    if (offers_.empty()) return;
    const StoredCase& content = offers_.front().content;
    const QString name = content.caseFile.empty()
                             ? tr("A case that was never saved")
                             : QFileInfo(QString::fromStdString(content.caseFile)).fileName();
    text_->setText(tr("%1 was open when the program ended: %2.").arg(name, said(content.unsavedSentence())));
    accept_->setText(tr("Recover"));
}

void RecoveryBar::tellRecovered(const QString& sentence) {
    autosave_.noteRecovered();
    ofOpenCase_ = true;
    text_->setText(
        tr("The program ended before this case was saved: %1. They are in place again.").arg(sentence));
    accept_->setText(tr("Keep"));
    show();
}

void RecoveryBar::accept() {
    if (ofOpenCase_) return offerNext();
    if (!mayLeave_()) return;
    const Abandoned chosen = offers_.front();
    loader_.recover(chosen, [this, chosen](bool opened) {
        if (!opened) return;
        std::erase_if(offers_, [&](const Abandoned& one) { return one.folder == chosen.folder; });
        if (!ofOpenCase_) offerNext();
    });
}

void RecoveryBar::discard() {
    if (ofOpenCase_) {
        autosave_.discardRecovered();
    } else {
        Autosaves::remove(offers_.front().folder);
        offers_.erase(offers_.begin());
    }
    offerNext();
}

}  // namespace vestige
