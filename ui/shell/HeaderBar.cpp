#include "ui/shell/HeaderBar.h"

#include <QAction>
#include <QDateTime>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/ActionText.h"
#include "ui/document/Document.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

/// A button that says what the action says, cut to a width that the bar can spare.
QPushButton* buttonFor(QAction& action, const QString& role) {
    auto* button = new QPushButton;
    button->setProperty("role", role);
    button->setFocusPolicy(Qt::TabFocus);
    const auto follow = [button, &action] {
        const QString text = withoutMnemonic(action.text());
        button->setText(button->fontMetrics().elidedText(text, Qt::ElideRight, 230));
        button->setToolTip(text + "\n" + action.statusTip());
        button->setEnabled(action.isEnabled());
    };
    QObject::connect(&action, &QAction::changed, button, follow);
    QObject::connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    follow();
    return button;
}

}  // namespace

HeaderBar::HeaderBar(const ActionCatalog& actions, Document& document, QWidget* parent)
    : QToolBar(parent), document_(document), title_(new QLabel), saved_(new QLabel) {
    setObjectName("header");
    setMovable(false);
    setIconSize(QSize(18, 18));
    auto* brand = new QLabel("Vestige");
    brand->setProperty("role", "brand");
    addWidget(brand);
    for (const char* id : {"file.open-case", "file.add-files", "file.save"}) addAction(&actions[id]);
    title_->setObjectName("case-title");
    title_->setContentsMargins(12, 0, 4, 0);
    saved_->setProperty("role", "muted");
    saved_->setContentsMargins(8, 0, 0, 0);
    addWidget(title_);
    auto* readOnly = new QLabel(tr("read-only"));
    readOnly->setObjectName("read-only");
    readOnly->setProperty("role", "trouble");
    readOnly->setContentsMargins(8, 0, 0, 0);
    readOnly_ = addWidget(readOnly);
    readOnly_->setVisible(false);
    addWidget(saved_);
    auto* right = new QWidget;
    auto* row = new QHBoxLayout(right);
    row->setContentsMargins(0, 0, 8, 0);
    row->setSpacing(8);
    row->addStretch(1);
    row->addWidget(buttonFor(actions["register.run"], "plain"));
    row->addWidget(buttonFor(actions["edit.undo"], "plain"));
    row->addWidget(buttonFor(actions["edit.redo"], "plain"));
    row->addWidget(buttonFor(actions["export.report"], "primary"));
    right->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(right);
    connect(&document_, &Document::changed, this, [this] { follow(); });
    connect(&document_, &Document::replaced, this, [this] { savedAt_ = storedAt_ = {}; });
    follow();
}

void HeaderBar::showReadOnly(const QString& reason) {
    readOnly_->setVisible(!reason.isEmpty());
    widgetForAction(readOnly_)->setToolTip(reason);
}

void HeaderBar::follow() {
    title_->setText(fontMetrics().elidedText(document_.title(), Qt::ElideRight, 320));
    const auto& file = document_.state().file;
    title_->setToolTip(toQt(file));
    const QString time = "HH:mm:ss";
    if (!document_.modified() && !file.empty()) {
        // The disk is asked once, not at each change.
        if (!savedAt_.isValid()) savedAt_ = QFileInfo(toQt(file)).lastModified();
        storedAt_ = {};
        saved_->setText(tr("saved %1").arg(savedAt_.toString(time)));
        saved_->setToolTip(tr("The case is saved as it is"));
        return;
    }
    savedAt_ = {};
    saved_->setToolTip(document_.modified() ? tr("Save case (Ctrl+S) makes what you see the case")
                                            : QString());
    if (!document_.modified())
        saved_->clear();
    else if (storedAt_.isValid())
        saved_->setText(tr("not saved, changes kept %1").arg(storedAt_.toString(time)));
    else
        saved_->setText(tr("not saved"));
}

void HeaderBar::showStored(bool stored) {
    if (!stored)
        storedAt_ = {};
    else if (!storedAt_.isValid())
        storedAt_ = QDateTime::currentDateTime();
    follow();
}

}  // namespace vestige
