#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "core/base/ParameterSet.h"

namespace vestige {

class ParameterEditor;

/// A form of every parameter of a table that a person may set: label, field, unit and help from the spec.
class ParameterForm : public QWidget {
    Q_OBJECT

  public:
    explicit ParameterForm(const ParameterTable& table, QWidget* parent = nullptr);
    void setValues(const ParameterSet& values);

  signals:
    /// A valid value was entered.
    void edited(const std::string& key, const ParameterValue& value);
    /// What was entered is not allowed; the sentence names parameter and range.
    void refused(const QString& sentence);

  private:
    void take(const std::string& key, const QString& text);

    ParameterSet values_;
    std::map<std::string, ParameterEditor*> editors_;
};

}  // namespace vestige
