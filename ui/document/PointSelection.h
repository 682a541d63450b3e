#pragma once

#include <QObject>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/scene/Cleaning.h"

namespace vestige {

class Document;

/// The points that the user has selected, and by what; not part of the case. Indices are into the layers'
/// points as loaded, so that a selection outlasts cleaning and its undo.
class PointSelection : public QObject {
    Q_OBJECT

  public:
    enum class Mode { replace, add, subtract };
    using Sets = std::map<std::string, PointSet>;  ///< by layer

    explicit PointSelection(const Document& document, QObject* parent = nullptr);

    /// Of layers that are loaded; others are left out. `step` says how the points were found.
    void apply(const Sets& found, Mode mode, CleaningStep step);
    void clear();
    /// What of each layer with data is not selected, nor taken out.
    Sets others() const;

    /// Null where nothing of the layer is selected.
    std::shared_ptr<const PointSet> of(const std::string& layer) const;
    std::size_t size() const;
    std::size_t layerCount() const { return parts_.size(); }
    /// By what: "lasso", "lasso, box".
    const CleaningStep& step() const { return step_; }

    /// The separated object that is worked on; empty: none.
    const std::string& object() const { return object_; }
    void setObject(std::string name);

    /// How far the last outline reached, from the eye, m.
    std::optional<std::pair<double, double>> reach() const { return reach_; }
    void setReach(std::optional<std::pair<double, double>> reach) { reach_ = reach; }

    /// At most so many of the selected points were not to be seen when outlines took them, as they lie behind
    /// others.
    std::size_t behind() const { return std::min(behind_, size()); }
    void setBehind(std::size_t count) { behind_ = count; }

  signals:
    void changed();

  private:
    struct Part {
        std::shared_ptr<const PointSet> points;
        std::weak_ptr<const LayerData> of;
    };
    void drop();

    const Document& document_;
    std::map<std::string, Part> parts_;
    CleaningStep step_;
    std::string object_;
    std::optional<std::pair<double, double>> reach_;
    std::size_t behind_ = 0;
};

}  // namespace vestige
