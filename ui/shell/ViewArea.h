#pragma once

#include <QWidget>
#include <vector>

class QLabel;

namespace vestige {

class ToolPalette;

/// The 3D view with what floats over it: tools at the top left, below them what the next click does, and the
/// welcome page while there is nothing to see.
class ViewArea : public QWidget {
    Q_OBJECT

  public:
    explicit ViewArea(QWidget* parent = nullptr);
    void setView(QWidget* view);
    void setTools(ToolPalette* tools);
    /// Stands below the tools, and the bars that were added before, while it is visible.
    void addBar(QWidget* bar);
    void setWelcome(QWidget* welcome);
    void showWelcome(bool show);
    void setHint(const QString& hint);
    /// Stands before the hint while the active tool needs it.
    void setChooser(QWidget* chooser);
    void showChooser(bool show);
    /// Where something stands over the view, in its pixels.
    std::vector<QRectF> covered() const;

  signals:
    /// What stands over the view has moved.
    void arranged();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void arrange();

    QWidget* view_ = nullptr;
    ToolPalette* tools_ = nullptr;
    std::vector<QWidget*> bars_;
    QWidget* welcome_ = nullptr;
    QWidget* chooser_ = nullptr;
    QLabel* hint_;
};

}  // namespace vestige
