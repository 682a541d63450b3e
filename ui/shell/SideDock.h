#pragma once

#include <QDockWidget>

class QTabWidget;

namespace vestige {

class ActionCatalog;
class GuidePage;
class Shortcuts;

/// Beside the panels, where it can be moved, floated and closed: the user guide, the tutorial and the
/// shortcuts. Made when it is first asked for.
class SideDock : public QDockWidget {
    Q_OBJECT

  public:
    SideDock(const ActionCatalog& actions, Shortcuts& shortcuts, QWidget* parent = nullptr);
    void showGuide();
    void showTutorial();
    void showShortcuts();

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void open(int tab);

    QTabWidget* tabs_;
    GuidePage* guide_;
    GuidePage* tutorial_;
};

}  // namespace vestige
