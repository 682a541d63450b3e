#include "ui/panels/EvidencePanel.h"

#include <QLabel>
#include <QTreeWidget>

#include "ui/document/Document.h"
#include "ui/document/Evidence.h"
#include "ui/document/Wording.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
namespace {

QString wordFor(EvidenceState state) {
    switch (state) {
        case EvidenceState::notRead:
            return QObject::tr("not read");
        case EvidenceState::hashed:
            return QObject::tr("hashed");
        case EvidenceState::unchanged:
            return QObject::tr("unchanged");
        case EvidenceState::touched:
            return QObject::tr("touched");
        case EvidenceState::changed:
            return QObject::tr("changed");
        case EvidenceState::missing:
            break;
    }
    return QObject::tr("missing");
}

QColor colorFor(EvidenceState state, const QPalette& palette) {
    if (state == EvidenceState::unchanged) return goodColor(palette);
    if (state == EvidenceState::changed || state == EvidenceState::missing || state == EvidenceState::touched)
        return isLight(palette) ? QColor(0xb9, 0x3a, 0x26) : QColor(0xf0, 0x8a, 0x7a);
    return quietColor(palette);
}

}  // namespace

EvidencePanel::EvidencePanel(Document& document, Evidence& evidence, QWidget* parent)
    : PanelSection(tr("Evidence"), parent),
      document_(document),
      evidence_(evidence),
      list_(new CompactList(tr("Files are hashed (SHA-256) as they are read."))) {
    list_->tree().setObjectName("evidence");
    list_->tree().setSelectionMode(QAbstractItemView::NoSelection);
    list_->tree().setAccessibleName(tr("Evidence"));
    setContent(list_);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&evidence_, &Evidence::changed, this, [this] { fill(); });
    onPaletteChange(*this, [this] { fill(); });
    fill();
}

void EvidencePanel::fill() {
    QTreeWidget& tree = list_->tree();
    tree.clear();
    for (const Layer& layer : document_.state().layers) {
        const EvidenceState state = evidence_.stateOf(layer.id);
        auto* row = new QTreeWidgetItem;
        row->setText(0, toQt(layer.path.filename()));
        row->setText(1, wordFor(state));
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        row->setForeground(1, colorFor(state, palette()));
        QString tip = toQt(layer.path);
        if (layer.data) tip += "\nSHA-256 " + QString::fromStdString(layer.data->sha256);
        if (const auto difference = evidenceDifference(layer)) tip += "\n" + said(*difference);
        row->setToolTip(0, tip);
        row->setToolTip(1, tip);
        tree.addTopLevelItem(row);
    }
    list_->fit();
}

}  // namespace vestige
