#include "ui/panels/LayersPanel.h"

#include <QLabel>
#include <QTreeWidget>

#include "core/scene/Edits.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/panels/LayerSwatch.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
namespace {

QString idOf(const QTreeWidgetItem* item) {
    return item ? item->data(0, Qt::UserRole).toString() : QString();
}

QTreeWidgetItem* rowOf(const Layer& layer, bool isTarget, const QColor& quiet) {
    auto* row = new QTreeWidgetItem;
    row->setText(0, QString::fromStdString(layer.name));
    row->setData(0, Qt::UserRole, QString::fromStdString(layer.id));
    row->setData(0, LayerSwatch::kColorRole, QColor(layer.tint[0], layer.tint[1], layer.tint[2]));
    row->setFlags(row->flags() | Qt::ItemIsUserCheckable);
    row->setCheckState(0, layer.visible ? Qt::Checked : Qt::Unchecked);
    const QString points = !layer.data               ? QObject::tr("not read")
                           : layer.data->isPreview() ? QObject::tr("%1 of %2")
                                                           .arg(countText(layer.data->points->size()),
                                                                countText(layer.data->awaitedPoints))
                           : layer.visible ? countText(layer.data->points->size())
                                           : QObject::tr("hidden");
    row->setText(1, points);
    row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    row->setForeground(1, quiet);
    if (!layer.visible || !layer.data) row->setForeground(0, quiet);
    const QString shown = layer.visible ? QObject::tr("shown; its square, or Space, hides it")
                                        : QObject::tr("hidden; its square, or Space, shows it");
    row->setToolTip(0, layerSummary(layer, isTarget) + "\n" + shown + "\n" + toQt(layer.path));
    return row;
}

}  // namespace

QString layerSummary(const Layer& layer, bool isTarget) {
    QStringList parts;
    QString role = said(name(layer.role));
    role[0] = role[0].toUpper();
    parts << role << (layer.unit ? toQt(symbol(*layer.unit)) : QObject::tr("unit not given"));
    if (layer.data) {
        parts << QString::fromStdString(layer.data->info.format);
        const auto triangles = layer.data->geometry->triangles.size();
        if (triangles > 0) parts << QObject::tr("%1 triangles").arg(countText(triangles));
    }
    if (layer.keepEvery > 1) parts << QObject::tr("every %1 point").arg(ordinalText(layer.keepEvery));
    if (layer.box) parts << QObject::tr("a part of the file");
    if (layer.data && layer.data->isPreview()) parts << QObject::tr("first look, the rest is being read");
    if (isTarget)
        parts << QObject::tr("target");
    else if (layer.registration)
        parts << QObject::tr("registered");
    return parts.join(QString::fromUtf8(" · "));
}

LayersPanel::LayersPanel(Document& document, Selection& selection, QWidget* parent)
    : PanelSection(tr("Layers"), parent),
      document_(document),
      selection_(selection),
      list_(new CompactList(tr("None yet. Drop scans here."))),
      details_(new QLabel) {
    details_->setProperty("role", "muted");
    details_->setWordWrap(true);
    details_->setContentsMargins(12, 2, 12, 0);
    list_->tree().setObjectName("layers");
    list_->tree().setAccessibleName(tr("Layers"));
    list_->tree().setItemDelegateForColumn(0, new LayerSwatch(this));
    setContent(list_);
    setContent(details_);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { describeSelected(); });
    connect(&list_->tree(), &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row, int column) {
        if (filling_ || column != 0) return;
        // The edit rebuilds the list, which must not happen while the list reports this change.
        const auto edit = [this, id = idOf(row).toStdString(), visible = row->checkState(0) == Qt::Checked] {
            document_.perform(setLayerVisible(id, visible));
        };
        QMetaObject::invokeMethod(this, edit, Qt::QueuedConnection);
    });
    connect(&list_->tree(), &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
        if (!filling_) selection_.setLayer(idOf(row).toStdString());
    });
    onPaletteChange(*this, [this] { fill(); });
    fill();
}

void LayersPanel::fill() {
    filling_ = true;
    QTreeWidget& tree = list_->tree();
    tree.clear();
    const SceneState& scene = document_.state();
    for (const Layer& layer : scene.layers) {
        auto* row = rowOf(layer, layer.id == scene.target, quietColor(palette()));
        tree.addTopLevelItem(row);
        if (layer.id == selection_.layer()) tree.setCurrentItem(row);
    }
    list_->fit();
    filling_ = false;
    describeSelected();
}

void LayersPanel::describeSelected() {
    const Layer* layer = document_.state().layer(selection_.layer());
    details_->setVisible(layer != nullptr);
    if (layer) details_->setText(layerSummary(*layer, layer->id == document_.state().target));
}

}  // namespace vestige
