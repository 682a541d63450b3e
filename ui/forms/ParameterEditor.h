#pragma once

#include <QWidget>

#include "core/base/ParameterSpec.h"

class QAbstractButton;
class QComboBox;
class QLineEdit;

namespace vestige {

/// The field of one parameter, made from its spec: a check box, a choice, or a number with unit and range;
/// "automatic" where the parameter may be. The object name is the parameter's key.
class ParameterEditor : public QWidget {
    Q_OBJECT

  public:
    explicit ParameterEditor(const ParameterSpec& spec, QWidget* parent = nullptr);
    void setValue(const ParameterValue& value);
    /// The reason why the text is no value; empty: none.
    void setProblem(const QString& sentence);

  signals:
    /// The user finished; text as ParameterSet::setFromText takes it.
    void edited(const QString& text);
    /// The field has the keys now.
    void entered();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    const ParameterSpec& spec_;
    QAbstractButton* check_ = nullptr;
    QComboBox* choice_ = nullptr;
    QLineEdit* field_ = nullptr;
};

}  // namespace vestige
