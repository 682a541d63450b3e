#pragma once

#include <QTreeWidget>
#include <set>

#include "core/scene/MeasuredKinds.h"

namespace vestige {

/// Every figure of an object with its uncertainty; each unfolds into its budget: what is uncertain, by how
/// much, and its share of the combined variance.
class FiguresTree : public QTreeWidget {
    Q_OBJECT

  public:
    explicit FiguresTree(QWidget* parent = nullptr);
    /// Null: none. What was unfolded stays so.
    void showFigures(const MeasuredKind* kind);

  private:
    void rememberFolds();

    std::set<QString> open_;  ///< keys of the figures that are unfolded
    std::string object_;
};

}  // namespace vestige
