#include "ui/shell/EmptyCasePage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/actions/ActionCatalog.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/CaseForm.h"

namespace vestige {
namespace {

QLabel* text(const QString& words, const QString& role) {
    auto* label = new QLabel(words);
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
}

}  // namespace

EmptyCasePage::EmptyCasePage(Document& document, Notices& notices, const ActionCatalog& actions,
                             QWidget* parent)
    : QWidget(parent) {
    setObjectName("empty-case");
    setAttribute(Qt::WA_StyledBackground);
    auto* card = new QWidget;
    card->setFixedWidth(430);
    auto* column = new QVBoxLayout(card);
    column->setSpacing(8);
    column->addWidget(text(tr("A new case"), "title"));
    column->addWidget(
        text(tr("Add the scans of the scene, the aerial cloud first: it becomes the frame that all "
                "others are registered to. Files can also be dropped here."),
             "muted"));
    column->addSpacing(8);
    auto* add = buttonFor(actions["file.add-files"]);
    add->setIcon(actions["file.add-files"].icon());
    add->setProperty("role", "primary");
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(add);
    buttons->addWidget(buttonFor(actions["file.open-case"]));
    buttons->addStretch(1);
    column->addLayout(buttons);
    column->addSpacing(16);
    column->addWidget(text(tr("For the report, now or later"), "heading"));
    column->addWidget(new CaseForm(document, notices));
    auto* whole = new QVBoxLayout(this);
    whole->addStretch(2);
    // A layout with alignment would not ask wrapped text for its height.
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(card);
    middle->addStretch(1);
    whole->addLayout(middle);
    whole->addStretch(3);
}

}  // namespace vestige
