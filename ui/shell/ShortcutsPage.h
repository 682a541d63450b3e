#pragma once

#include <QWidget>

class QKeySequence;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace vestige {

class ActionCatalog;
class Shortcuts;

/// Every action with its shortcut; the chosen one's can be changed, a conflict is said at once.
class ShortcutsPage : public QWidget {
    Q_OBJECT

  public:
    ShortcutsPage(const ActionCatalog& actions, Shortcuts& shortcuts, QWidget* parent = nullptr);

  private:
    std::string chosen() const;
    void fill();
    void filter();
    void showChosen();
    void judge(const QKeySequence& keys);

    const ActionCatalog& actions_;
    Shortcuts& shortcuts_;
    QLineEdit* search_;
    QTreeWidget* list_;
    QKeySequenceEdit* keys_;
    QLabel* message_;
    QPushButton* set_;
    QPushButton* none_;
    QPushButton* reset_;
};

}  // namespace vestige
