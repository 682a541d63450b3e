#include "ui/panels/ImportPanel.h"

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/base/Numbers.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/LayerForm.h"
#include "ui/panels/PanelSection.h"

namespace vestige {
namespace {

using Rows = std::vector<std::pair<QString, QString>>;

QString extentText(const Layer& layer) {
    const Eigen::Vector3d size = layer.data->info.bounds.extent() * layer.metresPerUnit();
    QStringList sides;
    for (int i = 0; i < 3; ++i) sides << toQt(fixedText(size[i], size.maxCoeff() < 10 ? 3 : 1));
    return sides.join(QString::fromUtf8(" × ")) + " m";
}

Rows factsOf(const Layer& layer) {
    Rows rows{{QObject::tr("File"), toQt(layer.path.filename())}};
    if (!layer.data) {
        rows.push_back({QObject::tr("State"), QObject::tr("not read")});
        return rows;
    }
    const FileInfo& info = layer.data->info;
    rows.push_back(
        {QObject::tr("Format"), toQt(info.version.empty() ? info.format : info.format + " " + info.version)});
    rows.push_back({QObject::tr("Points"), QString::number(layer.data->points->size())});
    if (!layer.data->geometry->triangles.empty())
        rows.push_back({QObject::tr("Triangles"), QString::number(layer.data->geometry->triangles.size())});
    rows.push_back({QObject::tr("Extent"), extentText(layer)});
    const bool given = layer.unit || layer.fileUnit();
    rows.push_back(
        {QObject::tr("Unit"), given ? toQt(symbol(layer.lengthUnit()))
                                    : QObject::tr("%1, taken for it").arg(toQt(symbol(layer.lengthUnit())))});
    if (layer.isThinned()) rows.push_back({QObject::tr("Loaded"), QObject::tr("a part of the file")});
    if (!info.damage.empty()) rows.push_back({QObject::tr("Damage"), toQt(info.damage)});
    rows.push_back({"SHA-256", layer.data->sha256.empty() ? QObject::tr("once all of it is read")
                                                          : toQt(layer.data->sha256)});
    return rows;
}

/// With places where a long hash may be broken.
QString breakable(const QString& text) {
    QString broken;
    for (int i = 0; i < text.size(); ++i) {
        if (i > 0 && i % 16 == 0 && text.size() == 64) broken += ' ';
        broken += text[i];
    }
    return broken;
}

}  // namespace

ImportPanel::ImportPanel(Document& document, Selection& selection, const ActionCatalog& actions,
                         QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      facts_(new QWidget),
      form_(new QFormLayout) {
    auto* content = new QWidget;
    content->setObjectName("panel-content");
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 6, 0, 6);
    column->setSpacing(6);
    auto* about =
        new QLabel(tr("Add the scans of the scene: clouds and meshes, by this button or dropped into the "
                      "window. The first is the frame that the others are registered to. Files are only "
                      "ever read; each is hashed."));
    about->setProperty("role", "muted");
    about->setWordWrap(true);
    addSection(*column, tr("Scans"), about);
    addSection(*column, tr("Layer"), new LayerForm(document, selection));
    facts_->setLayout(form_);
    form_->setContentsMargins(0, 0, 0, 0);
    form_->setHorizontalSpacing(12);
    form_->setVerticalSpacing(6);
    form_->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
    file_ = addSection(*column, tr("File"), facts_);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* add = buttonFor(actions["file.add-files"]);
    add->setProperty("role", "primary");
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll, 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(12, 6, 12, 12);
    foot->setSpacing(8);
    foot->addWidget(buttonFor(actions["file.verify"]));
    foot->addWidget(add, 1);
    whole->addLayout(foot);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { fill(); });
    fill();
}

void ImportPanel::fill() {
    const Layer* layer = document_.state().layer(selection_.layer());
    file_->setVisible(layer != nullptr);
    while (form_->rowCount() > 0) form_->removeRow(0);
    if (!layer) return;
    for (const auto& [name, value] : factsOf(*layer)) {
        auto* label = new QLabel(name);
        label->setProperty("role", "muted");
        auto* text = new QLabel(breakable(value));
        text->setWordWrap(true);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
        form_->addRow(label, text);
    }
}

}  // namespace vestige
