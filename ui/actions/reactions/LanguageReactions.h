#pragma once

#include <QObject>

#include "core/base/Language.h"
#include "ui/actions/Workbench.h"

namespace vestige {

/// The choice of a language: kept at once, used when the window opens again, which is offered.
class LanguageReactions : public QObject {
    Q_OBJECT

  public:
    explicit LanguageReactions(const Workbench& bench, QObject* parent = nullptr);

  private:
    void choose(Language language);
    void openAgain();

    Workbench bench_;
};

}  // namespace vestige
