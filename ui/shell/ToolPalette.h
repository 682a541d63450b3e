#pragma once

#include <QFrame>

class QLabel;

namespace vestige {

class ActionCatalog;
class Presentation;

/// The bar that floats over the view: tools, colours, before and after, point size, lighting; in several rows
/// where one has no room.
class ToolPalette : public QFrame {
    Q_OBJECT

  public:
    ToolPalette(const ActionCatalog& actions, Presentation& presentation, QWidget* parent = nullptr);
    /// What it takes of a place of that width.
    QSize sizeWithin(int width) const;
};

}  // namespace vestige
