#include "ui/shell/WelcomePage.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/RecentFiles.h"

namespace vestige {
namespace {

QPushButton* buttonFor(QAction& action, const QString& text, const QString& role) {
    auto* button = new QPushButton(action.icon(), text);
    button->setProperty("role", role);
    button->setToolTip(action.statusTip());
    QObject::connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    QObject::connect(&action, &QAction::changed, button,
                     [button, &action] { button->setIcon(action.icon()); });
    return button;
}

QLabel* text(const QString& words, const QString& role) {
    auto* label = new QLabel(words);
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
}

}  // namespace

WelcomePage::WelcomePage(const ActionCatalog& actions, const RecentFiles& recent, QWidget* parent)
    : QWidget(parent), recent_(recent), list_(new QVBoxLayout) {
    setObjectName("welcome");
    setAttribute(Qt::WA_StyledBackground);
    auto* card = new QWidget;
    card->setFixedWidth(440);
    auto* column = new QVBoxLayout(card);
    column->setSpacing(8);
    column->addWidget(text(tr("Begin with the aerial cloud"), "title"));
    column->addWidget(
        text(tr("Open a case, or add the scans of a scene: the first becomes the frame that all "
                "others are registered to. Files can also be dropped here."),
             "muted"));
    column->addSpacing(6);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(buttonFor(actions["file.open-case"], tr("Open case"), "primary"));
    buttons->addWidget(buttonFor(actions["file.add-files"], tr("Add clouds and meshes"), "plain"));
    buttons->addStretch(1);
    column->addLayout(buttons);
    column->addSpacing(14);
    list_->setSpacing(0);
    column->addLayout(list_);
    auto* whole = new QVBoxLayout(this);
    whole->addStretch(2);
    // A layout with alignment would not ask wrapped text for its height.
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(card);
    middle->addStretch(1);
    whole->addLayout(middle);
    whole->addStretch(3);
    connect(&recent_, &RecentFiles::changed, this, [this] { fillRecent(); });
    fillRecent();
}

void WelcomePage::fillRecent() {
    while (QLayoutItem* item = list_->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    const QStringList paths = recent_.paths();
    if (paths.isEmpty()) return;
    list_->addWidget(text(tr("Recent"), "heading"));
    for (const QString& path : paths.mid(0, 5)) {
        const QFileInfo file(path);
        auto* link = new QPushButton(file.fileName() + "    " + file.dir().dirName());
        link->setProperty("role", "link");
        link->setToolTip(path);
        link->setCursor(Qt::PointingHandCursor);
        connect(link, &QPushButton::clicked, this, [this, path] { emit chosen(path); });
        list_->addWidget(link);
    }
}

}  // namespace vestige
