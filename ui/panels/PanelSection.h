#pragma once

#include <QWidget>

class QHBoxLayout;
class QIcon;
class QLabel;
class QTreeWidget;
class QVBoxLayout;

namespace vestige {

/// A titled part of a side panel: heading, what stands at its right, content below.
class PanelSection : public QWidget {
    Q_OBJECT

  public:
    explicit PanelSection(const QString& title, QWidget* parent = nullptr);
    void addToHeading(QWidget* widget);
    void setContent(QWidget* content, int stretch = 0);

  private:
    QHBoxLayout* heading_;
};

/// Puts `content` into a section of that title at the end of `column`, and returns the section.
PanelSection* addSection(QVBoxLayout& column, const QString& title, QWidget* content);

/// A frameless list of name and value at its right, as high as its rows.
class CompactList : public QWidget {
    Q_OBJECT

  public:
    explicit CompactList(const QString& emptyText, QWidget* parent = nullptr);
    QTreeWidget& tree() { return *tree_; }
    /// After rows were added or removed.
    void fit();

  private:
    QTreeWidget* tree_;
    QLabel* empty_;
};

/// A round-cornered square of one colour, for layers.
QIcon swatch(const QColor& color);

}  // namespace vestige
