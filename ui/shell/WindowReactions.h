#pragma once

#include <QObject>

#include "ui/actions/Shortcuts.h"
#include "ui/actions/Workbench.h"

class QMainWindow;

namespace vestige {

class SceneView;
class SideDock;

/// What concerns the window itself: the clipboard, the whole screen, guide and shortcuts.
class WindowReactions : public QObject {
    Q_OBJECT

  public:
    WindowReactions(QMainWindow& window, const Workbench& bench, SceneView& view, QObject* parent = nullptr);

  private:
    void copyView();
    void copyTable();
    void fillScreen(bool on);
    void saveSheet();
    SideDock& dock();

    QMainWindow& window_;
    Workbench bench_;
    SceneView& view_;
    Shortcuts shortcuts_;
    SideDock* dock_ = nullptr;
};

}  // namespace vestige
