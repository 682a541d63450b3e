#pragma once

#include <QObject>
#include <QPointer>
#include <optional>

#include "ui/tools/LoupePicture.h"
#include "ui/tools/ProbedPlace.h"

class QPainter;

namespace vestige {

class Loupe;
class PickChoices;
class SceneView;
struct ViewCamera;
struct ViewTheme;

/// Shows what a click would take, for every tool that picks: the loupe beside the cursor, and the feature in
/// the picture.
class PickFeedback : public QObject {
    Q_OBJECT

  public:
    explicit PickFeedback(const PickChoices& choices, QObject* parent = nullptr);
    ~PickFeedback() override;

    void show(SceneView& view, const ProbedPlace& place);
    void hide();
    /// Of the tool's own paint().
    void paint(QPainter& painter, const ViewCamera& camera, const ViewTheme& theme) const;

  private:
    void showLoupe(SceneView& view, const ProbedPlace& place);

    const PickChoices& choices_;
    QPointer<SceneView> view_;
    QPointer<Loupe> loupe_;
    LoupePicture picture_;
    std::optional<ProbedPlace> shown_;
};

}  // namespace vestige
