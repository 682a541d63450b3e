#pragma once

#include <QDoubleSpinBox>
#include <QFrame>

class QAction;
class QGridLayout;
class QLabel;
class QToolButton;

namespace vestige {

class ActionCatalog;

/// A small bar over the view that belongs to an action: it has a title and a cross that ends it, and is there
/// while the action is checked.
class ViewBar : public QFrame {
    Q_OBJECT

  public:
    /// `action`: its id.
    ViewBar(ActionCatalog& actions, const char* action, const QString& title, const QString& name,
            QWidget* parent = nullptr);

  protected:
    QGridLayout& grid() { return *grid_; }

  private:
    QGridLayout* grid_;
};

/// Parts of such bars: a number with its unit, accessible name and tool tip; a button of an action.
QDoubleSpinBox* numberField(const QString& name, const QString& unit, const QString& help, double low,
                            double high, int decimals, double step);
QToolButton* barButton(QAction& action);
QLabel* barLabel(const QString& text);

}  // namespace vestige
