#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/ParameterSet.h"

class QFormLayout;
class QLabel;
class QToolButton;

namespace vestige {

class ParameterEditor;

/// A form of every parameter of a table that a person may set: label, field, unit and help from the spec.
/// What the field that has the keys means, its range and default stand below it.
class ParameterForm : public QWidget {
    Q_OBJECT

  public:
    /// Parameters other than `first` are folded away until somebody asks for them; none without such a list.
    explicit ParameterForm(const ParameterTable& table,
                           const std::optional<std::vector<std::string>>& first = std::nullopt,
                           QWidget* parent = nullptr);
    void setValues(const ParameterSet& values);

  signals:
    /// A valid value was entered.
    void edited(const std::string& key, const ParameterValue& value);
    /// What was entered is not allowed; the sentence names parameter and range.
    void refused(const QString& sentence);

  private:
    void take(const std::string& key, const QString& text);
    void explain(const std::string& key);
    void count();
    QWidget* makeMore(QWidget& folded);

    ParameterSet values_;
    ParameterSet defaults_;
    std::map<std::string, ParameterEditor*> editors_;
    std::vector<std::string> folded_;
    QToolButton* more_ = nullptr;
    QFormLayout* shown_ = nullptr;
    QFormLayout* rest_ = nullptr;
    QLabel* note_;  ///< below the field that has the keys
};

}  // namespace vestige
