#include "ui/forms/ParameterForm.h"

#include <QFormLayout>

#include "core/base/Translation.h"
#include "ui/document/Wording.h"
#include "ui/forms/ParameterEditor.h"

namespace vestige {

ParameterForm::ParameterForm(const ParameterTable& table, QWidget* parent) : QWidget(parent), values_(table) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    for (const ParameterSpec& spec : table) {
        auto* editor = new ParameterEditor(spec);
        connect(editor, &ParameterEditor::edited, this,
                [this, key = spec.key](const QString& text) { take(key, text); });
        auto* label = new QLabel(said(spec.label));
        label->setToolTip(said(spec.help));
        label->setBuddy(editor);
        form->addRow(label, editor);
        editors_[spec.key] = editor;
    }
    setValues(values_);
}

void ParameterForm::setValues(const ParameterSet& values) {
    values_ = values;
    for (const auto& [key, editor] : editors_) editor->setValue(values_.value(key));
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
    emit edited(key, values_.value(key));
}

}  // namespace vestige
