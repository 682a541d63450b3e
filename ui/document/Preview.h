#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "core/geometry/Pose.h"

namespace vestige {

/// A layer shown elsewhere than the case has it: an iteration of its registration, a pose that was refused, a
/// candidate. Not part of the case, so no edits.
class Preview : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    bool active() const { return !layer_.empty(); }
    const std::string& layer() const { return layer_; }
    const Similarity& sceneFromLayer() const { return sceneFromLayer_; }
    /// What is shown, for the view: "Iteration 7 of 21, voxels 0.50 m".
    const QString& words() const { return words_; }

    /// Who shows it; a preview of somebody else takes its place.
    const QObject* owner() const { return owner_; }
    void show(const QObject* owner, std::string layer, const Similarity& sceneFromLayer,
              const QString& words) {
        owner_ = owner;
        layer_ = std::move(layer);
        sceneFromLayer_ = sceneFromLayer;
        words_ = words;
        emit changed();
    }
    /// The layer stands where the case has it again.
    void end() {
        if (!active()) return;
        owner_ = nullptr;
        layer_.clear();
        words_.clear();
        emit changed();
    }

  signals:
    void changed();

  private:
    const QObject* owner_ = nullptr;
    std::string layer_;
    Similarity sceneFromLayer_;
    QString words_;
};

}  // namespace vestige
