#include "ui/panels/BudgetPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include "core/base/Numbers.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/KindEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/Icons.h"
#include "ui/actions/KindTools.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/ObjectNames.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/forms/ParameterForm.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/FiguresTree.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
namespace {

const MeasuredKind* measuredOf(const MeasuredScene& measured, const std::string& object,
                               const std::string& method) {
    for (const MeasuredKind& kind : measured.kinds)
        if (kind.object == object && kind.method == method) return &kind;
    return nullptr;
}

/// A number of the parameter's type as settings hold it.
std::optional<double> numberOf(const ParameterValue& value) {
    if (const auto* real = std::get_if<double>(&value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* on = std::get_if<bool>(&value)) return *on ? 1.0 : 0.0;
    return std::nullopt;
}

}  // namespace

BudgetPanel::BudgetPanel(Document& document, Selection& selection, Notices& notices,
                         const ActionCatalog& actions, QWidget* parent)
    : PanelSection(tr("Selected object"), parent),
      document_(document),
      selection_(selection),
      notices_(notices),
      kinds_(new QComboBox),
      check_(new QWidget),
      tolerance_(new QLineEdit),
      settings_(new QWidget),
      tree_(new FiguresTree),
      note_(new QLabel),
      empty_(new QLabel(tr("Select an object in the table to see its figures and what their uncertainty is "
                           "made of."))) {
    makeHead(actions);
    new QVBoxLayout(settings_);
    settings_->layout()->setContentsMargins(12, 0, 12, 4);
    for (QLabel* label : {note_, empty_}) {
        label->setProperty("role", "muted");
        label->setWordWrap(true);
        label->setContentsMargins(12, 2, 12, 6);
    }
    note_->setObjectName("figures-note");
    tree_->setMinimumHeight(96);
    setContent(check_);
    setContent(settings_);
    setContent(tree_, 1);
    setContent(note_);
    setContent(empty_);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { fill(); });
    onPaletteChange(*this, [this] { paintIcons(); });
    paintIcons();
    fill();
}

void BudgetPanel::paintIcons() {
    for (int i = 0; i < kinds_->count(); ++i) {
        const auto kind = static_cast<MeasurementKind>(kinds_->itemData(i).toInt());
        kinds_->setItemIcon(i, iconOn(palette(), QString::fromStdString(kindIcon(kind))));
    }
}

void BudgetPanel::makeHead(const ActionCatalog& actions) {
    kinds_->setObjectName("kind");
    kinds_->setAccessibleName(tr("Kind of measurement"));
    kinds_->setToolTip(tr("What is measured of the selected object"));
    for (const KindSpec& spec : kindTable()) {
        kinds_->addItem(said(spec.label), static_cast<int>(spec.kind));
        kinds_->setItemData(kinds_->count() - 1, said(spec.meaning), Qt::ToolTipRole);
    }
    connect(kinds_, qOverload<int>(&QComboBox::activated), this, [this](int row) {
        document_.perform(
            setKind(selection_.object(), static_cast<MeasurementKind>(kinds_->itemData(row).toInt())));
    });
    addToHeading(kinds_);

    tolerance_->setObjectName("check-tolerance");
    tolerance_->setAccessibleName(tr("Tolerance of the known distance, metres"));
    tolerance_->setToolTip(tr("How far the measured length may differ from the tape; metres above 0, usually "
                              "%1")
                               .arg(kUsualTolerance_m));
    tolerance_->setMaximumWidth(72);
    tolerance_->setAlignment(Qt::AlignRight);
    connect(tolerance_, &QLineEdit::editingFinished, this, [this] { takeTolerance(); });
    auto* row = new QHBoxLayout(check_);
    row->setContentsMargins(12, 0, 12, 4);
    row->addWidget(checkBoxFor(actions["measure.check"]));
    row->addStretch(1);
    row->addWidget(new QLabel(tr("within ±")));
    row->addWidget(tolerance_);
    row->addWidget(new QLabel(tr("m")));
}

void BudgetPanel::takeTolerance() {
    const Measurement* object = document_.state().measurement(selection_.object());
    if (!object || !object->checkTolerance_m) return;
    const auto metres = parseReal(tolerance_->text().trimmed().replace(',', '.').toStdString());
    if (metres && *metres > 0 && *metres <= 1000) {
        document_.perform(setCheck(object->object, metres));
    } else {
        notices_.warn(
            tr("\"%1\" is no tolerance: expected metres above 0, such as 0.02.").arg(tolerance_->text()));
        fill();
    }
}

void BudgetPanel::fillSettings() {
    const Measurement& object = *document_.state().measurement(selection_.object());
    const ParameterTable& table = *kindSpec(object.kind).parameters;
    if (!form_ || formKind_ != object.kind) {
        delete form_;
        form_ = new ParameterForm(table);
        formKind_ = object.kind;
        settings_->layout()->addWidget(form_);
        form_->show();
        connect(form_, &ParameterForm::edited, this,
                [this](const std::string& key, const ParameterValue& value) {
                    document_.perform(setKindSetting(selection_.object(), key, numberOf(value)));
                });
        connect(form_, &ParameterForm::refused, &notices_, &Notices::warn);
    }
    settings_->setVisible(!table.empty());
    if (const auto values = kindSettings(object.kind, object.settings)) form_->setValues(*values);
}

void BudgetPanel::fill() {
    const Measurement* object = document_.state().measurement(selection_.object());
    for (QWidget* widget : {static_cast<QWidget*>(kinds_), check_, settings_, static_cast<QWidget*>(tree_),
                            static_cast<QWidget*>(note_)})
        widget->setVisible(object != nullptr);
    empty_->setVisible(object == nullptr);
    // Without an object the room is the table's.
    setSizePolicy(QSizePolicy::Preferred, object ? QSizePolicy::Preferred : QSizePolicy::Maximum);
    if (!object) return tree_->showFigures(nullptr);
    for (int i = 0; i < kinds_->count(); ++i) {
        const auto kind = static_cast<MeasurementKind>(kinds_->itemData(i).toInt());
        if (kind == object->kind) kinds_->setCurrentIndex(i);
    }
    const bool isLength = kindSpec(object->kind).isLength;
    check_->setVisible(isLength);
    tolerance_->setEnabled(object->checkTolerance_m.has_value());
    tolerance_->setText(object->checkTolerance_m ? toQt(exactText(*object->checkTolerance_m)) : QString());
    fillSettings();
    const MeasuredKind* measured = measuredOf(document_.measured(), selection_.object(), selection_.method());
    tree_->setVisible(measured && !measured->quantities.empty());
    tree_->showFigures(measured);
    QString note = measured ? said(measured->note) : QString();
    if (measured && measured->quantities.empty() &&
        pickCount(*object, document_.state(), selection_.method()) == 0)
        note += tr(". Choose its tool above the view and click; three repeats make a measurement.");
    note_->setText(note);
    note_->setVisible(!note.isEmpty());
}

}  // namespace vestige
