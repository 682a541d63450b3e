#pragma once

#include <QObject>
#include <functional>

#include "core/geometry/ViewCamera.h"
#include "ui/actions/Workbench.h"

namespace vestige {

/// What the view shows and from where. Actions and Presentation follow each other.
class ViewReactions : public QObject {
    Q_OBJECT

  public:
    explicit ViewReactions(const Workbench& bench, QObject* parent = nullptr);

  signals:
    void namedViewWanted(NamedView view);

  private:
    void follow();

    Workbench bench_;
};

}  // namespace vestige
