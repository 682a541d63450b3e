#include "ui/panels/LayerForm.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "core/scene/Edits.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

enum Start { identity, fromCase, automatic };

constexpr LayerRole kRoles[] = {LayerRole::aerial, LayerRole::handheld, LayerRole::photogrammetry};

}  // namespace

LayerForm::LayerForm(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      empty_(new QLabel(tr("Select a layer to see what it is."))),
      fields_(new QWidget),
      name_(new QLineEdit),
      role_(new QComboBox),
      unit_(new QComboBox),
      start_(new QComboBox) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    empty_->setProperty("role", "muted");
    column->addWidget(empty_);
    column->addWidget(fields_);
    auto* form = new QFormLayout(fields_);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    for (const LayerRole role : kRoles) role_->addItem(said(vestige::name(role)));
    unit_->addItem(tr("recognise"));
    for (const LengthUnit unit : kLengthUnits) unit_->addItem(toQt(symbol(unit)));
    start_->addItems(
        {tr("where the file has it"), tr("pose or picks of the case"), tr("found automatically")});
    start_->setToolTip(
        tr("Where the registration of this layer starts. Found automatically: anywhere in the target, "
           "whatever the layer's pose and unit"));
    name_->setToolTip(tr("How the layer is called in the window and in the report"));
    role_->setToolTip(tr("What made the scan: it says how precise it is, and what is registered"));
    unit_->setToolTip(
        tr("What the file's coordinates are in; recognised from the file where nothing is chosen"));
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Role"), role_);
    form->addRow(tr("Unit"), unit_);
    form->addRow(tr("Start"), start_);
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        const std::string text = name_->text().trimmed().toStdString();
        if (!text.empty()) change("rename %1", [&](Layer& layer) { layer.name = text; });
    });
    connect(role_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        change("role of %1", [&](Layer& layer) {
            layer.role = kRoles[index];
            layer.method = defaultMethod(layer.role);
        });
    });
    connect(unit_, &QComboBox::textActivated, this, [this](const QString& text) {
        change("unit of %1", [&](Layer& layer) { layer.unit = lengthUnitFromSymbol(text.toStdString()); });
    });
    connect(start_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        if (index == fromCase) return fill();
        change("start of %1", [index](Layer& layer) {
            layer.init = index == automatic ? InitialPoseSpec(InitAuto()) : InitIdentity();
        });
    });
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { fill(); });
    fill();
}

void LayerForm::change(const QString& what, const std::function<void(Layer&)>& change) {
    const Layer* layer = document_.state().layer(selection_.layer());
    if (!layer) return;
    Layer changed = *layer;
    change(changed);
    const bool same = changed.name == layer->name && changed.role == layer->role &&
                      changed.method == layer->method && changed.unit == layer->unit &&
                      changed.init.index() == layer->init.index();
    if (same) return;
    document_.perform(
        changeLayer(std::move(changed), what.arg(QString::fromStdString(layer->name)).toStdString()));
}

void LayerForm::fill() {
    const Layer* layer = document_.state().layer(selection_.layer());
    empty_->setVisible(!layer);
    fields_->setVisible(layer != nullptr);
    if (!layer) return;
    if (!name_->isModified() || !name_->hasFocus()) name_->setText(QString::fromStdString(layer->name));
    role_->setCurrentText(said(vestige::name(layer->role)));
    unit_->setCurrentIndex(layer->unit ? unit_->findText(toQt(symbol(*layer->unit))) : 0);
    start_->setCurrentIndex(std::holds_alternative<InitIdentity>(layer->init) ? identity
                            : std::holds_alternative<InitAuto>(layer->init)   ? automatic
                                                                              : fromCase);
    const bool isTarget = layer->id == document_.state().target;
    start_->setEnabled(!isTarget);
}

}  // namespace vestige
