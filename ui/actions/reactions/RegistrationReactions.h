#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "core/registration/RegistrationResult.h"
#include "ui/actions/Workbench.h"

namespace vestige {

/// Registers layers on the job runner, enters what was found as one step, and resolves recorded aims.
class RegistrationReactions : public QObject {
    Q_OBJECT

  public:
    explicit RegistrationReactions(const Workbench& bench, QObject* parent = nullptr);

    /// The selected layer, else those not yet registered, else all but the target.
    void registerLayers();
    void resolveRecordedAims();

  private:
    std::vector<std::string> layersToRegister() const;
    void enter(const std::string& id, RegistrationResult result);

    Workbench bench_;
};

}  // namespace vestige
