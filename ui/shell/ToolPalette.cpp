#include "ui/shell/ToolPalette.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/KindTools.h"
#include "ui/document/Presentation.h"
#include "ui/shell/WrapLayout.h"

namespace vestige {
namespace {

QToolButton* buttonFor(QAction& action, Qt::ToolButtonStyle style) {
    auto* button = new QToolButton;
    button->setDefaultAction(&action);
    button->setToolButtonStyle(style);
    button->setAutoRaise(true);
    return button;
}

QFrame* gap() {
    auto* line = new QFrame;
    line->setFixedSize(1, 18);
    line->setProperty("role", "gap");
    return line;
}

QString colorText(const Presentation& shown) {
    if (shown.overlay() == Overlay::residual) return QObject::tr("Distance");
    if (shown.overlay() == Overlay::registration) return QObject::tr("Two tints");
    switch (shown.colorMode()) {
        case ColorMode::height:
            return QObject::tr("Height");
        case ColorMode::intensity:
            return QObject::tr("Intensity");
        case ColorMode::rgb:
            return QObject::tr("RGB");
        case ColorMode::classification:
            return QObject::tr("Class");
        case ColorMode::source:
            break;
    }
    return QObject::tr("Layer");
}

QToolButton* colorButton(const ActionCatalog& actions, Presentation& presentation) {
    auto* button = new QToolButton;
    button->setObjectName("color-mode");
    button->setAccessibleName(QObject::tr("Colour"));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolTip(QObject::tr("What the points' colour shows"));
    auto* menu = new QMenu(button);
    for (const char* id : {"view.color-source", "view.color-height", "view.color-intensity", "view.color-rgb",
                           "view.color-class"})
        menu->addAction(&actions[id]);
    menu->addSeparator();
    for (const char* id : {"register.tint", "register.residual"}) menu->addAction(&actions[id]);
    menu->addSeparator();
    menu->addAction(&actions["view.color-range"]);
    button->setMenu(menu);
    const auto name = [button, &presentation] { button->setText(colorText(presentation)); };
    QObject::connect(&presentation, &Presentation::changed, button, name);
    name();
    return button;
}

/// One button for the kinds of measurement besides the distance; it shows the one that was used last.
QToolButton* kindButton(const ActionCatalog& actions) {
    auto* button = new QToolButton;
    button->setObjectName("kinds");
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setText(QObject::tr("More"));
    button->setToolTip(QObject::tr("Measure something else: heights, angles, lines, arcs, areas, crush ..."));
    button->setAccessibleName(QObject::tr("Kinds of measurement"));
    auto* menu = new QMenu(button);
    const auto follow = [button, &actions] {
        bool on = false;
        for (const auto& [id, kind] : kindTools()) on = on || actions[id].isChecked();
        button->setChecked(on);
        button->setEnabled(actions["tool.angle"].isEnabled());
        button->setIcon(actions["tool.polyline"].icon());
        for (const auto& [id, kind] : kindTools()) {
            if (!actions[id].isChecked()) continue;
            button->setIcon(actions[id].icon());
        }
    };
    for (const auto& [id, kind] : kindTools()) {
        menu->addAction(&actions[id]);
        QObject::connect(&actions[id], &QAction::changed, button, follow);
    }
    QObject::connect(menu, &QMenu::aboutToHide, button, follow, Qt::QueuedConnection);
    button->setMenu(menu);
    follow();
    return button;
}

/// One button for the ways to compare; pressed while one is on.
QToolButton* compareButton(const ActionCatalog& actions) {
    auto* button = new QToolButton;
    button->setObjectName("compare");
    button->setAccessibleName(QObject::tr("Compare"));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolTip(QObject::tr("Compare two pictures of the scene: swipe, blink, checkerboard"));
    button->setCheckable(true);
    auto* menu = new QMenu(button);
    const std::vector<const char*> ways{"compare.swipe", "compare.blink", "compare.checkerboard"};
    const auto follow = [button, ways, &actions] {
        bool on = false;
        bool possible = false;
        for (const char* id : ways) {
            on = on || actions[id].isChecked();
            possible = possible || actions[id].isEnabled();
        }
        button->setIcon(actions["compare.swipe"].icon());
        button->setChecked(on);
        button->setEnabled(possible);
    };
    for (const char* id : ways) {
        menu->addAction(&actions[id]);
        QObject::connect(&actions[id], &QAction::changed, button, follow);
    }
    QObject::connect(menu, &QMenu::aboutToHide, button, follow, Qt::QueuedConnection);
    menu->addSeparator();
    for (const char* id : {"compare.poses", "compare.layers"}) menu->addAction(&actions[id]);
    button->setMenu(menu);
    follow();
    return button;
}

}  // namespace

ToolPalette::ToolPalette(const ActionCatalog& actions, Presentation& presentation, QWidget* parent)
    : QFrame(parent) {
    setObjectName("tool-palette");
    auto* row = new WrapLayout(this);
    row->setContentsMargins(3, 3, 3, 3);
    row->setSpacing(2);
    row->addWidget(buttonFor(actions["tool.orbit"], Qt::ToolButtonTextOnly));
    row->addWidget(buttonFor(actions["tool.distance"], Qt::ToolButtonTextOnly));
    row->addWidget(kindButton(actions));
    row->addWidget(buttonFor(actions["tool.lasso"], Qt::ToolButtonIconOnly));
    row->addWidget(buttonFor(actions["tool.box-select"], Qt::ToolButtonIconOnly));
    row->addGap(gap());
    row->addWidget(buttonFor(actions["register.tint"], Qt::ToolButtonIconOnly));
    row->addWidget(buttonFor(actions["register.before"], Qt::ToolButtonIconOnly));
    row->addWidget(compareButton(actions));
    row->addGap(gap());
    row->addWidget(colorButton(actions, presentation));
    row->addWidget(buttonFor(actions["view.edl"], Qt::ToolButtonIconOnly));
    row->addGap(gap());
    for (const char* id : {"view.fit", "view.four", "view.parallel", "view.section", "view.screenshot"})
        row->addWidget(buttonFor(actions[id], Qt::ToolButtonIconOnly));
}

QSize ToolPalette::sizeWithin(int width) const {
    const QSize frame = size() - contentsRect().size();
    return static_cast<WrapLayout*>(layout())->sizeWithin(width - frame.width()) + frame;
}

}  // namespace vestige
