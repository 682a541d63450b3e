#include "ui/panels/ActionButtons.h"

#include <QAction>
#include <QCheckBox>
#include <QPushButton>

#include "ui/actions/ActionText.h"

namespace vestige {
namespace {

void follow(QAbstractButton* button, QAction& action) {
    const auto take = [button, &action] {
        button->setText(withoutMnemonic(action.text()));
        button->setToolTip(action.toolTip());
        button->setEnabled(action.isEnabled());
        button->setCheckable(action.isCheckable());
        button->setChecked(action.isChecked());
    };
    QObject::connect(&action, &QAction::changed, button, take);
    QObject::connect(button, &QAbstractButton::clicked, &action, [button, &action] {
        action.trigger();
        // A click changes the button first; the action may have refused.
        button->setChecked(action.isChecked());
    });
    take();
}

}  // namespace

QPushButton* buttonFor(QAction& action) {
    auto* button = new QPushButton;
    follow(button, action);
    return button;
}

QCheckBox* checkBoxFor(QAction& action) {
    auto* box = new QCheckBox;
    follow(box, action);
    return box;
}

}  // namespace vestige
