#include "ui/panels/ViewsPanel.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/scene/SavedViewEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/ActionText.h"
#include "ui/document/Document.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
namespace {

constexpr int kScales[] = {20, 50, 100, 200, 250, 500, 1000};

/// What the right column says of a saved view.
QString useOf(const SavedView& view) {
    if (!view.inReport) return QObject::tr("not in report");
    return view.scale ? QStringLiteral("1:%1").arg(*view.scale) : QString();
}

}  // namespace

ViewsPanel::ViewsPanel(const ActionCatalog& actions, Document& document, QWidget* parent)
    : PanelSection(tr("Views"), parent), document_(document) {
    auto* keep = new QToolButton;
    keep->setDefaultAction(&actions["view.save"]);
    keep->setToolButtonStyle(Qt::ToolButtonIconOnly);
    keep->setAccessibleName(tr("Save view"));
    addToHeading(keep);
    setContent(makeNamed(actions));
    setContent(makeSaved(actions));
    connect(&document_, &Document::changed, this, [this] { fill(); });
    fill();
}

QWidget* ViewsPanel::makeNamed(const ActionCatalog& actions) {
    auto* list = new CompactList({});
    list->tree().setObjectName("views");
    list->tree().setAccessibleName(tr("Named views"));
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
    connect(&list->tree(), &QTreeWidget::itemClicked, this, [&actions](QTreeWidgetItem* row) {
        actions[row->data(0, Qt::UserRole).toString().toStdString()].trigger();
    });
    return list;
}

QWidget* ViewsPanel::makeSaved(const ActionCatalog& actions) {
    saved_ = new CompactList(tr("%1 keeps the view in the case, for you and the report.")
                                 .arg(actions["view.save"].shortcut().toString(QKeySequence::NativeText)));
    QTreeWidget& tree = saved_->tree();
    tree.setObjectName("saved-views");
    tree.setAccessibleName(tr("Saved views"));
    tree.setSelectionMode(QAbstractItemView::SingleSelection);
    tree.setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    tree.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&tree, &QTreeWidget::itemClicked, this,
            [this](QTreeWidgetItem* row) { emit wanted(row->data(0, Qt::UserRole).toString()); });
    connect(&tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row) { rename(row); });
    connect(&tree, &QTreeWidget::customContextMenuRequested, this,
            [this](const QPoint& at) { showMenu(at); });
    onPaletteChange(*this, [this] { fill(); });
    return saved_;
}

void ViewsPanel::fill() {
    QTreeWidget& tree = saved_->tree();
    const QSignalBlocker quiet(tree);
    const QString current =
        tree.currentItem() ? tree.currentItem()->data(0, Qt::UserRole).toString() : QString();
    tree.clear();
    for (const SavedView& view : document_.state().savedViews) {
        auto* row = new QTreeWidgetItem;
        const QString name = QString::fromStdString(view.name);
        row->setText(0, name);
        row->setData(0, Qt::UserRole, name);
        row->setFlags(row->flags() | Qt::ItemIsEditable);
        row->setText(1, useOf(view));
        row->setForeground(1, quietColor(palette()));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setToolTip(0,
                        tr("Click: go there. Double click or F2: rename. Right click: update, scale, report, "
                           "delete."));
        tree.addTopLevelItem(row);
        if (name == current) tree.setCurrentItem(row);
    }
    saved_->fit();
}

void ViewsPanel::editName(const QString& name) {
    QTreeWidget& tree = saved_->tree();
    for (int i = 0; i < tree.topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = tree.topLevelItem(i);
        if (row->data(0, Qt::UserRole).toString() != name) continue;
        tree.setCurrentItem(row);
        tree.editItem(row, 0);
    }
}

void ViewsPanel::rename(QTreeWidgetItem* row) {
    const QString before = row->data(0, Qt::UserRole).toString();
    const QString now = row->text(0).trimmed();
    if (now == before) return;
    // The list is filled anew once the editor is closed.
    QMetaObject::invokeMethod(
        this,
        [this, before, now] {
            if (!document_.perform(renameSavedView(before.toStdString(), now.toStdString()))) fill();
        },
        Qt::QueuedConnection);
}

void ViewsPanel::showMenu(const QPoint& place) {
    const QTreeWidgetItem* row = saved_->tree().itemAt(place);
    if (!row) return;
    const QString name = row->data(0, Qt::UserRole).toString();
    const SavedView* found = savedView(document_.state(), name.toStdString());
    if (!found) return;
    const SavedView view = *found;
    const auto change = [this](SavedView changed) { document_.perform(setSavedView(std::move(changed))); };
    QMenu menu;
    menu.setObjectName("saved-view-menu");
    menu.addAction(tr("Go there"), this, [this, name] { emit wanted(name); });
    menu.addAction(tr("Replace by what is seen now"), this, [this, name] { emit updateWanted(name); });
    menu.addAction(tr("Rename"), this, [this, name] { editName(name); });
    QAction* report = menu.addAction(tr("In the report"));
    report->setCheckable(true);
    report->setChecked(view.inReport);
    connect(report, &QAction::toggled, this, [change, view](bool on) {
        SavedView changed = view;
        changed.inReport = on;
        change(changed);
    });
    QMenu* scales = menu.addMenu(tr("Scale in print"));
    scales->setEnabled(view.camera.parallel);
    const auto addScale = [&](const QString& text, std::optional<int> scale) {
        QAction* action = scales->addAction(text);
        action->setCheckable(true);
        action->setChecked(view.scale == scale);
        connect(action, &QAction::triggered, this, [change, view, scale] {
            SavedView changed = view;
            changed.scale = scale;
            change(changed);
        });
    };
    addScale(tr("As large as the page allows"), std::nullopt);
    for (const int scale : kScales) addScale(QStringLiteral("1:%1").arg(scale), scale);
    menu.addSeparator();
    menu.addAction(tr("Delete"), this,
                   [this, name] { document_.perform(removeSavedView(name.toStdString())); });
    menu.exec(saved_->tree().viewport()->mapToGlobal(place));
}

}  // namespace vestige
