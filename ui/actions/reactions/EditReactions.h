#pragma once

#include <QObject>

#include "ui/actions/Workbench.h"

namespace vestige {

/// Undo, redo, and the changes of layers and objects that need no form.
class EditReactions : public QObject {
    Q_OBJECT

  public:
    explicit EditReactions(const Workbench& bench, QObject* parent = nullptr);

  private:
    void updateTexts();
    void addObject();
    void removeLastPick();

    Workbench bench_;
};

}  // namespace vestige
