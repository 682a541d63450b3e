#pragma once

#include <QObject>
#include <QString>

#include "core/measurement/FittedFeature.h"

namespace vestige {

/// How picks are made in the view. Not part of the case, so no edits; what a pick was snapped to is kept with
/// the pick.
class PickChoices : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    SnapMode snap() const { return snap_; }
    /// A magnified picture of the place under the cursor.
    bool loupe() const { return loupe_; }
    /// The picks of the selected object can be dragged outside of the measuring tool, too.
    bool movable() const { return movable_; }

    void setSnap(SnapMode snap) { set(snap_, snap); }
    void setLoupe(bool on) { set(loupe_, on); }
    void setMovable(bool on) { set(movable_, on); }
    /// The next one in the order of SnapMode; the first after the last.
    void nextSnap();

  signals:
    void changed();

  private:
    template <class T>
    void set(T& field, T value) {
        if (field == value) return;
        field = value;
        emit changed();
    }

    SnapMode snap_ = SnapMode::point;
    bool loupe_ = true;
    bool movable_ = false;
};

/// Every mode, in the order of the menu.
inline constexpr SnapMode kSnapModes[] = {SnapMode::point,  SnapMode::plane,    SnapMode::edge,
                                          SnapMode::corner, SnapMode::highest,  SnapMode::lowest,
                                          SnapMode::circle, SnapMode::centroid, SnapMode::surface};

/// "edge": of the chooser and the loupe.
QString snapText(SnapMode mode);
/// "on an edge": what the next click takes, within a sentence.
QString snapPhrase(SnapMode mode);

}  // namespace vestige
