#pragma once

#include <QColor>
#include <QWidget>
#include <vector>

class QHBoxLayout;

namespace vestige {

/// Figures side by side: a large value and below it, small, what it is. Where there is no room for all of
/// them the last ones are left out, whole.
class FiguresRow : public QWidget {
    Q_OBJECT

  public:
    struct Figure {
        QString value;
        QString caption;
        QColor color;  ///< of the value; invalid: that of text
    };
    explicit FiguresRow(QWidget* parent = nullptr);
    /// `size` of the style's roles: "figure" (large) or "figure-small".
    void setFigures(const std::vector<Figure>& figures, const QString& role = "figure");
    /// Values and captions, for tests and screen readers.
    QString text() const { return accessibleDescription(); }

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void showWhatFits();

    QHBoxLayout* row_;
    std::vector<QWidget*> cells_;
};

}  // namespace vestige
