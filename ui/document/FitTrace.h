#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/registration/RegistrationWatch.h"

namespace vestige {

class Document;
class Preview;

/// The iterations of watched registrations, by layer: while one runs its layer is shown where the fit has it
/// (at most 30 times a second, always the latest step); afterwards the steps stay and can be shown one by
/// one. GUI thread, but for what watches() gives.
class FitTrace : public QObject {
    Q_OBJECT

  public:
    using Steps = std::vector<RegistrationStep>;
    /// What watches the registration of the layer named; called and used on the worker's thread. It keeps the
    /// step and returns at once.
    using Watches = std::function<RegistrationWatch(const std::string& layer)>;

    FitTrace(const Document& document, Preview& preview, QObject* parent = nullptr);

    /// Begins to follow; the steps of layers that are watched again are replaced.
    Watches begin();
    /// Takes what is still to come and ends the showing.
    void finish();
    bool live() const { return mailbox_ != nullptr; }
    /// The layer whose registration runs; empty until its first step.
    const std::string& liveLayer() const { return liveLayer_; }

    /// Empty for a layer that was not watched.
    const Steps& steps(const std::string& layer) const;
    /// The step that is shown, of the layer that the preview shows; while live the latest one.
    std::optional<std::size_t> cursor(const std::string& layer) const;
    /// Shows the layer where that step had it.
    void replay(const std::string& layer, std::size_t step);

  signals:
    /// Steps came, or another one is shown.
    void changed();

  private:
    struct Mailbox;
    void take();
    void showStep(const std::string& layer, std::size_t step);

    const Document& document_;
    Preview& preview_;
    std::shared_ptr<Mailbox> mailbox_;
    QTimer timer_;
    std::map<std::string, Steps> steps_;
    std::string liveLayer_;
    std::string shownLayer_;
    std::size_t shownStep_ = 0;
};

}  // namespace vestige
