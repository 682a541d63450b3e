#pragma once

#include <QFrame>

class QLabel;
class QSlider;

namespace vestige {

class ActionCatalog;
class Comparison;
class Preview;

/// Floats below the tools while the view shows something else than the case: which two pictures are compared,
/// with the size of the tiles or the speed of the blinking; or what is previewed. And the way back.
class CompareBar : public QFrame {
    Q_OBJECT

  public:
    CompareBar(const ActionCatalog& actions, Comparison& comparison, const Preview& preview,
               QWidget* parent = nullptr);

  private:
    void follow();

    Comparison& comparison_;
    const Preview& preview_;
    QWidget* what_;
    QLabel* words_;
    QLabel* amount_;
    QSlider* slider_;
};

}  // namespace vestige
