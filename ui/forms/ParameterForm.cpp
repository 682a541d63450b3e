#include "ui/forms/ParameterForm.h"

#include <QFormLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/Translation.h"
#include "ui/document/Wording.h"
#include "ui/forms/ParameterEditor.h"
#include "ui/forms/ParameterHelp.h"

namespace vestige {
namespace {

QFormLayout* newForm(QWidget* parent = nullptr) {
    auto* form = new QFormLayout(parent);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    return form;
}

}  // namespace

ParameterForm::ParameterForm(const ParameterTable& table,
                             const std::optional<std::vector<std::string>>& first, QWidget* parent)
    : QWidget(parent), values_(table), defaults_(table), note_(new QLabel(this)) {
    note_->setProperty("role", "muted");
    note_->setWordWrap(true);
    note_->hide();
    std::vector<QLabel*> labels;
    const auto add = [&](const ParameterSpec& spec, QFormLayout& form) {
        auto* editor = new ParameterEditor(spec);
        connect(editor, &ParameterEditor::edited, this,
                [this, key = spec.key](const QString& text) { take(key, text); });
        connect(editor, &ParameterEditor::entered, this, [this, key = spec.key] { explain(key); });
        auto* label = new QLabel(said(spec.label));
        label->setToolTip(parameterHelp(spec));
        label->setBuddy(editor);
        form.addRow(label, editor);
        labels.push_back(label);
        editors_[spec.key] = editor;
    };
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    shown_ = newForm();
    column->addLayout(shown_);
    auto* folded = new QWidget;
    rest_ = newForm(folded);
    for (const ParameterSpec& spec : table) {
        const bool isFirst = !first || std::find(first->begin(), first->end(), spec.key) != first->end();
        if (!isFirst) folded_.push_back(spec.key);
        add(spec, isFirst ? *shown_ : *rest_);
    }
    // One column of labels in both parts.
    int widest = 0;
    for (const QLabel* label : labels) widest = std::max(widest, label->sizeHint().width());
    for (QLabel* label : labels) label->setMinimumWidth(widest);
    folded->hide();
    if (!folded_.empty()) column->addWidget(makeMore(*folded), 0, Qt::AlignLeft);
    column->addWidget(folded);
    setValues(values_);
}

QWidget* ParameterForm::makeMore(QWidget& folded) {
    more_ = new QToolButton;
    more_->setObjectName("more-parameters");
    more_->setProperty("role", "fold");
    more_->setCheckable(true);
    more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    more_->setArrowType(Qt::RightArrow);
    more_->setToolTip(tr("Show or hide what an expert may want to change"));
    connect(more_, &QToolButton::toggled, &folded, [this, &folded](bool on) {
        folded.setVisible(on);
        more_->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    });
    return more_;
}

void ParameterForm::setValues(const ParameterSet& values) {
    values_ = values;
    for (const auto& [key, editor] : editors_) editor->setValue(values_.value(key));
    count();
}

void ParameterForm::explain(const std::string& key) {
    ParameterEditor* editor = editors_[key];
    for (QFormLayout* form : {shown_, rest_}) {
        if (form->indexOf(note_) < 0) continue;
        const QFormLayout::TakeRowResult before = form->takeRow(note_);
        delete before.labelItem;
        delete before.fieldItem;
    }
    QFormLayout* form = shown_->indexOf(editor) >= 0 ? shown_ : rest_;
    int row = 0;
    QFormLayout::ItemRole role{};
    form->getWidgetPosition(editor, &row, &role);
    note_->setText(editor->toolTip());
    form->insertRow(row + 1, note_);
    note_->show();
}

/// How much is folded away, and whether any of it is not as it comes.
void ParameterForm::count() {
    if (!more_) return;
    const auto changed = std::count_if(folded_.begin(), folded_.end(), [this](const std::string& key) {
        return values_.value(key) != defaults_.value(key);
    });
    const QString all =
        (shown_->rowCount() > 0 ? tr("%1 more") : tr("%1 parameters")).arg(static_cast<int>(folded_.size()));
    more_->setText(changed == 0 ? tr("%1, all at their defaults").arg(all)
                                : tr("%1, %2 changed").arg(all).arg(changed));
}

void ParameterForm::take(const std::string& key, const QString& text) {
    ParameterSet wanted = values_;
    if (const Status set = wanted.setFromText(key, text.toStdString()); !set) {
        const QString sentence = QString::fromStdString(say(set.error()));
        editors_[key]->setProblem(sentence);
        emit refused(sentence);
        return;
    }
    editors_[key]->setProblem({});
    values_ = wanted;
    count();
    emit edited(key, values_.value(key));
}

}  // namespace vestige
