#pragma once

#include <QObject>

#include "ui/actions/Workbench.h"

namespace vestige {

/// The known-distance check of the selected object: action and document follow each other.
class KindReactions : public QObject {
    Q_OBJECT

  public:
    explicit KindReactions(const Workbench& bench, QObject* parent = nullptr);

  private:
    void follow();
    void setChecked(bool on);

    Workbench bench_;
};

}  // namespace vestige
