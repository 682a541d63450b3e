#pragma once

#include <QWidget>
#include <vector>

#include "core/base/ParameterSet.h"

class QLabel;

namespace vestige {

class ActionCatalog;
class Document;
class Notices;
class ParameterForm;
class PointSelection;
class Selection;
struct CleaningSettings;

/// Taking points out of the scene, from top to bottom: what is selected and what can be done with it;
/// selecting by hand, outliers, ground, objects, each with its parameters; what was taken out so far.
class CleanPanel : public QWidget {
    Q_OBJECT

  public:
    CleanPanel(Document& document, Selection& selection, PointSelection& points, CleaningSettings& settings,
               Notices& notices, const ActionCatalog& actions, QWidget* parent = nullptr);

  private:
    QWidget* makeSelected(const ActionCatalog& actions);
    QWidget* makeStep(const ActionCatalog& actions, const QString& meaning, ParameterForm* form,
                      const std::vector<const char*>& ids);
    QWidget* makeRemoved(const ActionCatalog& actions);
    ParameterForm* formFor(ParameterSet& settings, Notices& notices);
    void describeSelected();
    void describeRemoved();

    Document& document_;
    Selection& selection_;
    PointSelection& points_;
    QLabel* selected_ = nullptr;
    QLabel* reach_ = nullptr;
    QLabel* behind_ = nullptr;  ///< what is selected without being seen
    QLabel* removed_ = nullptr;
};

}  // namespace vestige
