#include "ui/shell/ViewBar.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>

#include "ui/actions/ActionCatalog.h"

namespace vestige {

ViewBar::ViewBar(ActionCatalog& actions, const char* id, const QString& title, const QString& name,
                 QWidget* parent)
    : QFrame(parent), grid_(new QGridLayout) {
    QAction& action = actions[id];
    setObjectName(name);
    setProperty("role", "view-bar");
    setAccessibleName(title);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 5, 6, 8);
    column->setSpacing(4);
    auto* head = new QHBoxLayout;
    auto* label = new QLabel(title);
    label->setProperty("role", "heading");
    head->addWidget(label, 1);
    auto* close = new QToolButton;
    close->setText(QString::fromUtf8("×"));
    close->setToolTip(tr("Close") + "\n" + action.statusTip());
    close->setAccessibleName(tr("Close"));
    connect(close, &QToolButton::clicked, &action, [&action] { action.setChecked(false); });
    head->addWidget(close);
    column->addLayout(head);
    grid_->setHorizontalSpacing(6);
    grid_->setVerticalSpacing(4);
    column->addLayout(grid_);
    actions.onToggled(id, [this](bool on) { setVisible(on); });
    setVisible(action.isChecked());
}

QDoubleSpinBox* numberField(const QString& name, const QString& unit, const QString& help, double low,
                            double high, int decimals, double step) {
    auto* field = new QDoubleSpinBox;
    field->setLocale(QLocale::c());
    field->setRange(low, high);
    field->setDecimals(decimals);
    field->setSingleStep(step);
    if (!unit.isEmpty()) field->setSuffix(" " + unit);
    field->setAccessibleName(name);
    field->setToolTip(help);
    field->setKeyboardTracking(false);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    field->setFixedWidth(104);
    return field;
}

QToolButton* barButton(QAction& action) {
    auto* button = new QToolButton;
    button->setDefaultAction(&action);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAccessibleName(action.text().remove('&'));
    return button;
}

QLabel* barLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("role", "muted");
    return label;
}

}  // namespace vestige
