#pragma once

#include <QObject>
#include <QPoint>
#include <QTimer>
#include <optional>

#include "core/geometry/Picking.h"

class QMouseEvent;

namespace vestige {

class SceneView;

/// Picks under a resting or slowly moving cursor: at most some 25 times a second, never while a button is
/// down.
class HoverProbe : public QObject {
    Q_OBJECT

  public:
    explicit HoverProbe(QObject* parent = nullptr);
    void moved(SceneView& view, const QMouseEvent& event);
    /// Asks once more where the cursor rests: the picture under it has changed.
    void again();
    void stop();
    /// Where the last answer was asked for.
    QPoint position() const { return position_; }

  signals:
    /// Nothing where no point is under the cursor.
    void hovered(const std::optional<Pick>& pick);

  private:
    void probe();

    QTimer timer_;
    SceneView* view_ = nullptr;
    QPoint position_;
};

}  // namespace vestige
