#include "ui/forms/ParameterEditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QStyle>

#include "core/base/Numbers.h"
#include "ui/document/Wording.h"
#include "ui/forms/ParameterHelp.h"

namespace vestige {
namespace {

QString valueText(const ParameterValue& value) {
    if (const auto* real = std::get_if<double>(&value)) return QString::fromStdString(exactText(*real));
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return QString::number(*integer);
    if (const auto* text = std::get_if<std::string>(&value)) return QString::fromStdString(*text);
    return {};
}

}  // namespace

ParameterEditor::ParameterEditor(const ParameterSpec& spec, QWidget* parent) : QWidget(parent), spec_(spec) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    if (spec.type == ParameterType::boolean) {
        check_ = new QCheckBox;
        connect(check_, &QAbstractButton::clicked, this,
                [this](bool on) { emit edited(on ? "true" : "false"); });
        row->addWidget(check_);
        row->addStretch();
    } else if (spec.type == ParameterType::choice) {
        choice_ = new QComboBox;
        for (const auto& choice : spec.choices)
            choice_->addItem(said(choice), QString::fromStdString(choice));
        connect(choice_, QOverload<int>::of(&QComboBox::activated), this,
                [this](int index) { emit edited(choice_->itemData(index).toString()); });
        row->addWidget(choice_, 1);
    } else {
        field_ = new QLineEdit;
        if (spec.mayBeAutomatic()) field_->setPlaceholderText(tr("automatic"));
        connect(field_, &QLineEdit::editingFinished, this, [this] {
            if (!field_->isModified()) return;
            field_->setModified(false);
            const QString text = field_->text().trimmed();
            emit edited(text.isEmpty() && spec_.mayBeAutomatic() ? QStringLiteral("auto") : text);
        });
        row->addWidget(field_, 1);
        auto* unit = new QLabel(QString::fromStdString(spec.unit));
        unit->setProperty("role", "muted");
        unit->setMinimumWidth(22);
        row->addWidget(unit);
    }
    QWidget* editor = layout()->itemAt(0)->widget();
    editor->setObjectName(QString::fromStdString(spec.key));
    editor->setAccessibleName(said(spec.label));
    editor->setAccessibleDescription(parameterHelp(spec));
    setToolTip(parameterHelp(spec));
    editor->installEventFilter(this);
    setFocusProxy(editor);
}

void ParameterEditor::setValue(const ParameterValue& value) {
    if (check_) {
        const bool* on = std::get_if<bool>(&value);
        check_->setChecked(on && *on);
    } else if (choice_) {
        choice_->setCurrentIndex(choice_->findData(valueText(value)));
    } else if (!field_->hasFocus() || !field_->isModified()) {
        field_->setText(valueText(value));
    }
    setProblem({});
}

void ParameterEditor::setProblem(const QString& sentence) {
    setToolTip(sentence.isEmpty() ? parameterHelp(spec_) : sentence);
    QWidget* editor = focusProxy();
    editor->setProperty("problem", !sentence.isEmpty());
    editor->style()->unpolish(editor);
    editor->style()->polish(editor);
}

bool ParameterEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) emit entered();
    return QWidget::eventFilter(watched, event);
}

}  // namespace vestige
