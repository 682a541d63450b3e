#include "ui/panels/PartsPanel.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QTreeWidget>

#include "core/base/Numbers.h"
#include "core/scene/CleaningEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/PointSelection.h"
#include "ui/document/Wording.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
namespace {

QString sizeText(const SceneObject& object) {
    QStringList sides;
    for (const double side : object.size_m)
        sides << QString::fromStdString(fixedText(side, side < 1 ? 2 : 1));
    return sides.join(QString::fromUtf8(" × "));
}

QString kindText(const std::string& kind) {
    if (kind == "vehicle") return PartsPanel::tr("vehicle");
    if (kind == "debris") return PartsPanel::tr("debris");
    if (kind == "vegetation") return PartsPanel::tr("pole or plant");
    if (kind == "ground") return PartsPanel::tr("ground");
    return PartsPanel::tr("other");
}

QString summary(const SceneObject& object, const Layer* layer) {
    QStringList lines;
    lines << PartsPanel::tr("%1: %2, %3 points of %4")
                 .arg(QString::fromStdString(object.name), kindText(object.kind),
                      countText(object.points ? object.points->size() : 0),
                      QString::fromStdString(layer ? layer->name : object.layer));
    lines << PartsPanel::tr("%1 m, the upright box round its points; no measurement").arg(sizeText(object));
    if (layer && loadedData(*layer) && !belongsTo(object, *layer))
        lines << PartsPanel::tr("Its points are of another file or part than the one that is loaded.");
    return lines.join("\n");
}

}  // namespace

PartsPanel::PartsPanel(Document& document, PointSelection& points, const ActionCatalog& actions,
                       QWidget* parent)
    : PanelSection(tr("Parts of the scene"), parent),
      document_(document),
      points_(points),
      actions_(actions),
      list_(new CompactList(tr("None yet. Clean (Ctrl+4) separates vehicles and debris."))),
      buttons_(new QWidget) {
    QTreeWidget& tree = list_->tree();
    tree.setObjectName("parts");
    tree.setAccessibleName(tr("Parts of the scene"));
    tree.setToolTip(tr("Tick to show, double-click to rename"));
    tree.setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    tree.setContextMenuPolicy(Qt::CustomContextMenu);
    setContent(list_);
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(12, 2, 12, 2);
    row->setSpacing(2);
    for (const char* id : {"part.select", "part.zoom", "part.remove"}) {
        auto* button = new QToolButton;
        button->setDefaultAction(&actions_[id]);
        button->setAutoRaise(true);
        button->setAccessibleName(actions_[id].text().remove('&'));
        row->addWidget(button);
    }
    row->addStretch(1);
    setContent(buttons_);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&points_, &PointSelection::changed, this, [this] { fill(); });
    connect(&tree, &QTreeWidget::itemChanged, this,
            [this](QTreeWidgetItem* item, int column) { take(item, column); });
    connect(&tree, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (filling_) return;
        const std::string name = item ? item->data(0, Qt::UserRole).toString().toStdString() : std::string();
        QMetaObject::invokeMethod(
            this, [this, name] { points_.setObject(name); }, Qt::QueuedConnection);
    });
    connect(&tree, &QTreeWidget::customContextMenuRequested, this,
            [this](const QPoint& place) { showMenu(place); });
    onPaletteChange(*this, [this] { fill(); });
    fill();
}

void PartsPanel::fill() {
    QTreeWidget& tree = list_->tree();
    // A name that is being typed must not be taken from under the fingers.
    const QWidget* typing = QApplication::focusWidget();
    if (filling_ || (typing && tree.viewport()->isAncestorOf(typing))) return;
    filling_ = true;
    tree.clear();
    const SceneState& scene = document_.state();
    for (const SceneObject& object : scene.objects) {
        const Layer* layer = scene.layer(object.layer);
        auto* row = new QTreeWidgetItem;
        row->setFlags(row->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
        row->setText(0, QString::fromStdString(object.name));
        row->setData(0, Qt::UserRole, row->text(0));
        row->setCheckState(0, object.visible ? Qt::Checked : Qt::Unchecked);
        row->setText(1, sizeText(object));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setForeground(1, quietColor(palette()));
        if (!object.visible) row->setForeground(0, quietColor(palette()));
        row->setToolTip(0, summary(object, layer));
        row->setToolTip(1, row->toolTip(0));
        tree.addTopLevelItem(row);
        if (object.name == points_.object()) tree.setCurrentItem(row);
    }
    list_->fit();
    buttons_->setVisible(!scene.objects.empty());
    filling_ = false;
}

void PartsPanel::take(QTreeWidgetItem* row, int column) {
    if (filling_ || column != 0) return;
    const std::string name = row->data(0, Qt::UserRole).toString().toStdString();
    const std::string typed = row->text(0).trimmed().toStdString();
    const bool visible = row->checkState(0) == Qt::Checked;
    // The edit fills the list anew, which must not happen while the list reports this change.
    const auto edit = [this, name, typed, visible] {
        if (typed != name) {
            points_.setObject({});
            const bool renamed = document_.perform(renameObject(name, typed));
            points_.setObject(renamed ? typed : name);
        }
        document_.perform(setObjectVisible(typed != name ? points_.object() : name, visible));
        fill();
    };
    QMetaObject::invokeMethod(this, edit, Qt::QueuedConnection);
}

void PartsPanel::showMenu(const QPoint& place) {
    const QTreeWidgetItem* row = list_->tree().itemAt(place);
    if (!row) return;
    const std::string name = row->data(0, Qt::UserRole).toString().toStdString();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const char* id : {"part.select", "part.zoom", "part.remove"}) menu->addAction(&actions_[id]);
    menu->addSeparator();
    for (const std::string& kind : objectKinds())
        connect(menu->addAction(tr("It is: %1").arg(kindText(kind))), &QAction::triggered, this,
                [this, name, kind] { document_.perform(setObjectKind(name, kind)); });
    menu->popup(list_->tree().viewport()->mapToGlobal(place));
}

void PartsPanel::editName(const std::string& name) {
    QTreeWidget& tree = list_->tree();
    for (int i = 0; i < tree.topLevelItemCount(); ++i)
        if (QTreeWidgetItem* row = tree.topLevelItem(i);
            row->data(0, Qt::UserRole).toString().toStdString() == name) {
            tree.setCurrentItem(row);
            tree.setFocus();
            tree.editItem(row, 0);
        }
}

}  // namespace vestige
