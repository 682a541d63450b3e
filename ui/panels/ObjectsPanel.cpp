#include "ui/panels/ObjectsPanel.h"

#include <QLabel>
#include <QTreeWidget>

#include "ui/document/Document.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/panels/PanelColors.h"

namespace vestige {

ObjectsPanel::ObjectsPanel(Document& document, Selection& selection, QWidget* parent)
    : PanelSection(tr("Objects"), parent),
      document_(document),
      selection_(selection),
      list_(new CompactList(tr("Nothing is measured yet."))) {
    list_->tree().setObjectName("objects");
    list_->tree().setAccessibleName(tr("Objects"));
    setContent(list_);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { fill(); });
    connect(&list_->tree(), &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) {
        const std::string object = row->text(0).toStdString();
        QMetaObject::invokeMethod(
            this, [this, object] { selection_.setObject(object); }, Qt::QueuedConnection);
    });
    onPaletteChange(*this, [this] { fill(); });
    fill();
}

void ObjectsPanel::fill() {
    QTreeWidget& tree = list_->tree();
    tree.clear();
    const SceneState& scene = document_.state();
    for (const Measurement& measurement : scene.measurements) {
        auto* row = new QTreeWidgetItem;
        const std::size_t picks = pickCount(measurement, scene, selection_.method());
        row->setText(0, QString::fromStdString(measurement.object));
        row->setText(1, picks > 3 ? QString::number(picks) : tr("%1 of 3").arg(picks));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setForeground(1, picks >= 3 ? goodColor(palette()) : quietColor(palette()));
        row->setToolTip(0, row->text(0));
        tree.addTopLevelItem(row);
        if (measurement.object == selection_.object()) tree.setCurrentItem(row);
    }
    list_->fit();
}

}  // namespace vestige
