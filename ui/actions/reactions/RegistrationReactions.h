#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/registration/RegistrationResult.h"
#include "core/scene/Layer.h"
#include "ui/actions/Workbench.h"

namespace vestige {

/// Registers layers on the job runner, enters the poses that can be relied on as one step, keeps the others
/// to be looked at, and resolves recorded aims.
class RegistrationReactions : public QObject {
    Q_OBJECT

  public:
    explicit RegistrationReactions(const Workbench& bench, QObject* parent = nullptr);

    /// The selected layer, else those not yet registered, else all but the target; from `start` in place of
    /// their own first poses.
    void registerLayers(const std::optional<InitialPoseSpec>& start = std::nullopt);
    /// Registers the layer described from the candidate chosen.
    void useCandidate();
    void resolveRecordedAims();

  private:
    std::vector<std::string> layersToRegister() const;
    std::string described() const;
    void follow();
    /// The iteration before or after the one shown.
    void stepReplay(int direction);
    void run(const std::vector<std::string>& layers, const std::optional<InitialPoseSpec>& start);
    /// Enters or keeps a result; a sentence for the user unless all is well.
    QString take(const std::string& id, Result<RegistrationResult> result,
                 const std::optional<InitialPoseSpec>& start);
    void enter(const std::string& id, RegistrationResult result, const std::optional<InitialPoseSpec>& start);

    Workbench bench_;
    bool watch_ = false;  ///< keep the iterations of what is registered
};

}  // namespace vestige
