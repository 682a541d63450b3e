#include "ui/panels/ViewsPanel.h"

#include <QAction>
#include <QLabel>
#include <QTreeWidget>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/ActionText.h"
#include "ui/panels/PanelColors.h"

namespace vestige {

ViewsPanel::ViewsPanel(const ActionCatalog& actions, QWidget* parent) : PanelSection(tr("Views"), parent) {
    auto* list = new CompactList({});
    list->tree().setObjectName("views");
    list->tree().setAccessibleName(tr("Views"));
    list->tree().setSelectionMode(QAbstractItemView::NoSelection);
    for (const char* id : {"view.perspective", "view.top", "view.front", "view.left", "view.iso"}) {
        const QAction& action = actions[id];
        auto* row = new QTreeWidgetItem;
        row->setText(0, withoutMnemonic(action.text()));
        row->setText(1, action.shortcut().toString(QKeySequence::NativeText));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setData(0, Qt::UserRole, QString(id));
        row->setToolTip(0, action.statusTip());
        list->tree().addTopLevelItem(row);
    }
    const auto color = [this, list] {
        for (int i = 0; i < list->tree().topLevelItemCount(); ++i)
            list->tree().topLevelItem(i)->setForeground(1, quietColor(palette()));
    };
    color();
    onPaletteChange(*this, color);
    list->fit();
    setContent(list);
    connect(&list->tree(), &QTreeWidget::itemClicked, this, [&actions](QTreeWidgetItem* row) {
        actions[row->data(0, Qt::UserRole).toString().toStdString()].trigger();
    });
}

}  // namespace vestige
